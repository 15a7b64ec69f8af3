# SPDX-License-Identifier: MIT
"""Motions that follow from several blocks: chamfers, roundings, splines."""
