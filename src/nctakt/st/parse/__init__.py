# SPDX-License-Identifier: MIT
"""Structured Text -> tokens -> syntax tree."""
