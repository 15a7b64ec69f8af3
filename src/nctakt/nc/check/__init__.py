# SPDX-License-Identifier: MIT
"""From the tree to diagnostics."""
