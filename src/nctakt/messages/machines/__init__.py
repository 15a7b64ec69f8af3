# SPDX-License-Identifier: MIT
"""Messages about machine folders and their lists."""
