# SPDX-License-Identifier: MIT
"""The language server ``nctakt lsp``: programs and lists in editors (extra ``editor``)."""
