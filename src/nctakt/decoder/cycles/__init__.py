# SPDX-License-Identifier: MIT
"""Definitions of realtime cycles turned into trees that run in the tick."""
