# SPDX-License-Identifier: MIT
"""The scheduling list of a machine, and its checks."""
