# SPDX-License-Identifier: MIT
"""Kinematic transformations: positions of the axes and of the tool, in both directions."""
