# SPDX-License-Identifier: MIT
"""The past of a session: branches, records, parked controllers."""
