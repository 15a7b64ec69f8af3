# SPDX-License-Identifier: MIT
"""What inputs are called on a tape; loads nothing, so that plain Python can still be chosen."""

#: What a written value is among the inputs; where those come from that the user's own code sets.
WRITE, API = "write", "api"
