# SPDX-License-Identifier: MIT
"""Display around a text: colours, hints, hover, outline."""
