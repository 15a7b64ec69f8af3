# SPDX-License-Identifier: MIT
"""Structured Text as trees of small objects over one memory of bytes."""
