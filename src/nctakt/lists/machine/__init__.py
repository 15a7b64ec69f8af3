# SPDX-License-Identifier: MIT
"""A folder of lists -> an immutable machine."""
