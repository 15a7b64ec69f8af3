# SPDX-License-Identifier: MIT
"""Names of inputs on a tape; loads nothing, so that plain Python can still be chosen."""

#: The kind of a written value among the inputs; the source of inputs set by the user's code.
WRITE, API = "write", "api"
