# SPDX-License-Identifier: MIT
"""Coordinates, arcs and curves, as the decoder reckons with them."""
