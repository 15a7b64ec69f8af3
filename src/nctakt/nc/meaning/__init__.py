# SPDX-License-Identifier: MIT
"""From words and commands of the tree to their meaning, for the checker and the decoder."""
