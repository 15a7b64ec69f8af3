# SPDX-License-Identifier: MIT
"""Access to a run from outside, by names: inputs, values, the interface, tapes."""
