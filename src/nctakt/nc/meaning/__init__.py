# SPDX-License-Identifier: MIT
"""From words and commands of the tree to what they say, for the checker and the decoder."""
