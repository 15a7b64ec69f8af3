# SPDX-License-Identifier: MIT
"""Parts of a comparison that can be sent to others, without anything private."""
