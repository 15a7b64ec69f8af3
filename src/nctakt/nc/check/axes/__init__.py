# SPDX-License-Identifier: MIT
"""Checks of commands to single axes and spindles."""
