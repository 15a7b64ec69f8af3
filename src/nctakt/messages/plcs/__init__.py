# SPDX-License-Identifier: MIT
"""Messages about the PLC: its code, its interface, its replacements."""
