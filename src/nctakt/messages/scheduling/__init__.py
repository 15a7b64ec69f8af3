# SPDX-License-Identifier: MIT
"""Messages about scheduling lists and their results."""
