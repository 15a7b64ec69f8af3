# SPDX-License-Identifier: MIT
"""Why reactions fired or did not, as data and as text."""
