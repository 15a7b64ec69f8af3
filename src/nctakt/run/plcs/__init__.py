# SPDX-License-Identifier: MIT
"""PLCs and simulations in the loop of ticks."""
