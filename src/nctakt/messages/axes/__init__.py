# SPDX-License-Identifier: MIT
"""Messages about single axes and spindles."""
