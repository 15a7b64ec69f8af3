# SPDX-License-Identifier: MIT
"""What reaches a run from outside, by names: inputs, values, the interface, tapes."""
