# SPDX-License-Identifier: MIT
"""The users' files: read within bounds, and written without loss."""
