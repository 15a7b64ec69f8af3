# SPDX-License-Identifier: MIT
"""Parts of a PLC written in Python: users' files as modules, blocks of Structured Text."""
