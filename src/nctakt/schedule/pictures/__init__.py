# SPDX-License-Identifier: MIT
"""Schedules as pictures, and as traces for other viewers."""
