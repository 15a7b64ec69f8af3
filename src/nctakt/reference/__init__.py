# SPDX-License-Identifier: MIT
"""Articles about the controller for readers: ``nctakt explain`` and the reference documents."""
