# SPDX-License-Identifier: MIT
"""The words of a block turned into commands."""
