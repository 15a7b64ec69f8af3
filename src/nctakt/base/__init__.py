# SPDX-License-Identifier: MIT
"""What every stage uses: diagnostics, failures, texts and places in them."""
