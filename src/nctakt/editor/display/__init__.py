# SPDX-License-Identifier: MIT
"""What is shown around a text: colours, hints, hover, outline."""
