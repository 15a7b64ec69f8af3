# SPDX-License-Identifier: MIT
"""Words that concern single axes and spindles."""
