# SPDX-License-Identifier: MIT
"""The interface image between CNC and PLC (HLI): what stands in it and where."""
