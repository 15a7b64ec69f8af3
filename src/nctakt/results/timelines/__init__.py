# SPDX-License-Identifier: MIT
"""A run over time: tracks of slices for viewers."""
