# SPDX-License-Identifier: MIT
"""What of a comparison can be sent to others, without anything private."""
