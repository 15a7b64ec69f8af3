# SPDX-License-Identifier: MIT
"""The runs of a plan in one process."""
