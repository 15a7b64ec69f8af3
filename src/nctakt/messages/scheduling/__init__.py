# SPDX-License-Identifier: MIT
"""Messages about scheduling lists and what comes of them."""
