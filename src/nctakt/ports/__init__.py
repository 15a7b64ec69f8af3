# SPDX-License-Identifier: MIT
"""Ports of this computer at which editors and debuggers come in, with the token of the command."""
