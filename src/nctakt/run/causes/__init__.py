# SPDX-License-Identifier: MIT
"""Why a run waits, and the causes of its errors."""
