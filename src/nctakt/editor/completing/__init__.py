# SPDX-License-Identifier: MIT
"""What can be written at the cursor."""
