# SPDX-License-Identifier: MIT
"""Messages about the PLC: its code, its interface, what runs in its place."""
