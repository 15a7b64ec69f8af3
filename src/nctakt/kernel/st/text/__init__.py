# SPDX-License-Identifier: MIT
"""Numbers, dates and texts of PLC code."""
