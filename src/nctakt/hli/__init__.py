# SPDX-License-Identifier: MIT
"""The interface image between CNC and PLC (HLI): its values and their offsets."""
