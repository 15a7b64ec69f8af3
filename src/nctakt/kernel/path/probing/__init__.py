# SPDX-License-Identifier: MIT
"""Measuring and stops within a block: probes, edge joints, fixed stops."""
