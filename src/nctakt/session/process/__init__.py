# SPDX-License-Identifier: MIT
"""The processes and the thread that a session lives in."""
