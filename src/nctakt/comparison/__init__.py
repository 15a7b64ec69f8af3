# SPDX-License-Identifier: MIT
"""A machine's log compared with a run: reading logs, mapping, alignment, deviations."""
