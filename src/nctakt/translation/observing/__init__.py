# SPDX-License-Identifier: MIT
"""Observation of PLC code by users: branches, causes of changes, statements."""
