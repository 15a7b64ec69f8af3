# SPDX-License-Identifier: MIT
"""From lines to the tree, and back to text."""
