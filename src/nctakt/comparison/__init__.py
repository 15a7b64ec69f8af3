# SPDX-License-Identifier: MIT
"""A machine's log laid over a run: reading logs, mapping, alignment, deviations."""
