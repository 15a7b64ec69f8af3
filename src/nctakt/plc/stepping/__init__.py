# SPDX-License-Identifier: MIT
"""Inside a cycle of a PLC in Structured Text: its statements, calls and variables."""
