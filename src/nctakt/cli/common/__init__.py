# SPDX-License-Identifier: MIT
"""The common part of the commands: options, settings, terminal, help."""
