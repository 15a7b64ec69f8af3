# SPDX-License-Identifier: MIT
"""A channel's tick: the command queue and the execution of its commands."""
