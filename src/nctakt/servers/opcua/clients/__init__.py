# SPDX-License-Identifier: MIT
"""Clients: their connections, sessions and subscriptions."""
