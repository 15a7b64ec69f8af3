# SPDX-License-Identifier: MIT
"""Runs whose decoder, interpolation and PLC have limited time."""
