# SPDX-License-Identifier: MIT
"""Checks of the path: blocks that move, their shapes and coordinates."""
