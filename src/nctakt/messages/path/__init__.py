# SPDX-License-Identifier: MIT
"""Messages about the path of a tool: feed, shapes, transformations, measuring."""
