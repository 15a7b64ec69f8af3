# SPDX-License-Identifier: MIT
"""The declarations of each kind of list."""
