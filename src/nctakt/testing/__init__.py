# SPDX-License-Identifier: MIT
"""Tests of NC programs with pytest; the plugin loads what it needs when a test asks for it."""
