# SPDX-License-Identifier: MIT
"""Plain blocks decoded without a tree; compiled."""
