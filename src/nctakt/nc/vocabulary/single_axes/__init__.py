# SPDX-License-Identifier: MIT
"""The commands in brackets after the name of an axis."""
