# SPDX-License-Identifier: MIT
"""Searches: the best point, a switch-over, branches that no run has reached."""
