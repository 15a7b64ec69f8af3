# SPDX-License-Identifier: MIT
"""The past of a session: branches, what was recorded, parked controllers."""
