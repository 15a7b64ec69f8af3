# SPDX-License-Identifier: MIT
"""The realtime part; ``nctakt.base.mode`` decides in which form its modules are imported."""

from nctakt.base import mode as mode
