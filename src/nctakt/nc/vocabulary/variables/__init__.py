# SPDX-License-Identifier: MIT
"""The variables of the language: names, types, rights, cells."""
