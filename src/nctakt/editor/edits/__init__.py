# SPDX-License-Identifier: MIT
"""Findings -> the edits that remedy them."""
