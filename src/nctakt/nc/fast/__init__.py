# SPDX-License-Identifier: MIT
"""Short cuts for plain lines and for statements of a known shape."""
