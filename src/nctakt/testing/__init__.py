# SPDX-License-Identifier: MIT
"""Tests of NC programs with pytest; the plugin imports nctakt only for a test that needs it."""
