# SPDX-License-Identifier: MIT
"""Words that shape the path and its feed."""
