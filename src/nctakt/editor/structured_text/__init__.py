# SPDX-License-Identifier: MIT
"""Structured Text in editors: projects that change while they are typed, and answers about them."""
