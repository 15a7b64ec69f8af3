# SPDX-License-Identifier: MIT
"""Structured Text: files of a PLC project -> a checked program."""
