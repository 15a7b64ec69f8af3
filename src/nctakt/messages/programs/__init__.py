# SPDX-License-Identifier: MIT
"""Messages about NC programs: their text, their statements, their cycles."""
