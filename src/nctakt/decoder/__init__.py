# SPDX-License-Identifier: MIT
"""Checked program -> commands; ``nctakt.base.mode`` selects compiled or plain modules."""

from nctakt.base import mode as mode
