# SPDX-License-Identifier: MIT
"""Kinematic transformations in channel lists."""
