# SPDX-License-Identifier: MIT
"""Kinematics of the lists turned into maps of the realtime part."""
