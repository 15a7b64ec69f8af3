# SPDX-License-Identifier: MIT
"""Observation of running PLC code: counts, causes, statements."""
