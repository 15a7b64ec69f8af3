# SPDX-License-Identifier: MIT
"""Geometry of the tool's centre path; compiled."""
