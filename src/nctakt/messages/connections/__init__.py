# SPDX-License-Identifier: MIT
"""Messages about those who connect: editors, debuggers, browsers, clients."""
