# SPDX-License-Identifier: MIT
"""Why a run waits, and what its errors mean."""
