# SPDX-License-Identifier: MIT
"""A folder of lists turned into an immutable machine."""
