# SPDX-License-Identifier: MIT
"""Checked program -> commands; ``nctakt.base.mode`` decides in which form its modules are
imported."""

from nctakt.base import mode as mode
