# SPDX-License-Identifier: MIT
"""A session that clients on the network find: one loop, several endpoints."""
