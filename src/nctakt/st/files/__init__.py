# SPDX-License-Identifier: MIT
"""Files of a PLC project: objects in XML or plain text, and the project that lists them."""
