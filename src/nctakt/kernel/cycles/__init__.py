# SPDX-License-Identifier: MIT
"""Realtime cycles as trees of objects that run themselves."""
