# SPDX-License-Identifier: MIT
"""Findings about code that is valid but likely meant otherwise."""
