# SPDX-License-Identifier: MIT
"""Diagnostics, failures, texts and positions in them: used by every stage."""
