# SPDX-License-Identifier: MIT
"""What a user watches of PLC code: branches, causes of changes, statements."""
