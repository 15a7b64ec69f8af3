# SPDX-License-Identifier: MIT
"""Control structures, calls, macros and loops of a program."""
