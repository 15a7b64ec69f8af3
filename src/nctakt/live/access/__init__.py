# SPDX-License-Identifier: MIT
"""Who may see the page: addresses, connections, places."""
