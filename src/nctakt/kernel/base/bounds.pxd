# SPDX-License-Identifier: MIT
# bounds.py has no C types: its numbers are Python's, which may have any size.
