# SPDX-License-Identifier: MIT
"""Findings and results in the formats of readers and of other tools."""
