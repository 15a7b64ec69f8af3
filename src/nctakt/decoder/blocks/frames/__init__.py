# SPDX-License-Identifier: MIT
"""Coordinate systems and transformations that a program selects."""
