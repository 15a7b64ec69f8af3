# SPDX-License-Identifier: MIT
"""Completion at the cursor."""
