# SPDX-License-Identifier: MIT
"""The text of a list, and entries checked against declarations."""
