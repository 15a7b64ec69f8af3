# SPDX-License-Identifier: MIT
"""Pictures of runs: path, motion over time, reactions (extra ``plot``)."""
