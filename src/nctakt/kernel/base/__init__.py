# SPDX-License-Identifier: MIT
"""Arithmetic, records and timers of the realtime part."""
