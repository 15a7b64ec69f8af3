# SPDX-License-Identifier: MIT
"""The users' files: read within bounds, written so that nothing is lost."""
