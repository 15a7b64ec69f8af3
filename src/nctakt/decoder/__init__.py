# SPDX-License-Identifier: MIT
"""Checked program -> commands; ``nctakt.mode`` decides in which form its modules are imported."""

from nctakt import mode as mode
