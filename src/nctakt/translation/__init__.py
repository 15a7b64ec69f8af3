# SPDX-License-Identifier: MIT
"""Checked PLC programs in Structured Text -> trees of the realtime part."""
