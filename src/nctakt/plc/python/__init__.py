# SPDX-License-Identifier: MIT
"""What of a PLC is written in Python: users' files as modules, blocks of Structured Text."""
