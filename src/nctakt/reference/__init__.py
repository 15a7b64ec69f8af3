# SPDX-License-Identifier: MIT
"""What nctakt knows, as articles for people: ``nctakt explain`` and the reference documents."""
