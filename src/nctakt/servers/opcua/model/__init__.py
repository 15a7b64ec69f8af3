# SPDX-License-Identifier: MIT
"""The companion models: their types as facts, and as nodes."""
