# SPDX-License-Identifier: MIT
"""The version of nctakt, as reports, documents and tapes name it."""

__version__ = "0.3.0"
