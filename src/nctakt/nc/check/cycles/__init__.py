# SPDX-License-Identifier: MIT
"""Checks of realtime cycles and realtime loops."""
