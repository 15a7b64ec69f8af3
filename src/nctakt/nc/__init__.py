# SPDX-License-Identifier: MIT
"""NC text -> checked program; ``nctakt.base.mode`` selects compiled or plain modules."""

from nctakt.base import mode as mode
