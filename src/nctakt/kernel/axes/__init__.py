# SPDX-License-Identifier: MIT
"""Axes and spindles: coordinates, trajectories and independent motion."""
