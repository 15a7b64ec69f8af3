# SPDX-License-Identifier: MIT
"""The variables lists of a machine: V.E, their layout and checks."""
