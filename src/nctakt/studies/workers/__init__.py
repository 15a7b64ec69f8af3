# SPDX-License-Identifier: MIT
"""Other processes that make runs: on this machine, or on a cluster."""
