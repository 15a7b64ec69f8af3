# SPDX-License-Identifier: MIT
"""The realtime part of a machine: assembled, kept, put back."""
