# SPDX-License-Identifier: MIT
"""A model -> its schedule in virtual time, counted and recorded."""
