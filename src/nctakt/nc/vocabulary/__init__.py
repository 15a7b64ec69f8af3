# SPDX-License-Identifier: MIT
"""The words, commands, functions and variables of the language."""
