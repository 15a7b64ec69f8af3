# SPDX-License-Identifier: MIT
"""The path: segments, limits, look-ahead, and the motion along them."""
