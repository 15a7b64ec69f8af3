# SPDX-License-Identifier: MIT
"""Simulation and analysis as text, and for other programs."""
