# SPDX-License-Identifier: MIT
"""A session for clients on the network: one loop, several endpoints."""
