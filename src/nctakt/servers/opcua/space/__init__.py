# SPDX-License-Identifier: MIT
"""The machine as nodes of the companion models."""
