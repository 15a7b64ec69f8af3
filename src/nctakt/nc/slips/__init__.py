# SPDX-License-Identifier: MIT
"""Slips of those who are new to the language, and habits from other controls."""
