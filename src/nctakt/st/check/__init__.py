# SPDX-License-Identifier: MIT
"""From the syntax tree to a checked program: names, types, layout."""
