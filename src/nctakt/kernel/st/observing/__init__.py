# SPDX-License-Identifier: MIT
"""What is watched of running PLC code: counts, causes, statements."""
