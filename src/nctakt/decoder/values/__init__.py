# SPDX-License-Identifier: MIT
"""Expressions and variables, evaluated when decoded or built for the tick."""
