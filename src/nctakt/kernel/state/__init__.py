# SPDX-License-Identifier: MIT
"""Copies of the state of the realtime part."""
