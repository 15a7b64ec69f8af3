# SPDX-License-Identifier: MIT
"""Bounds in closed form, margins, suggestions, comparisons."""
