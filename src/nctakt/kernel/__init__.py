# SPDX-License-Identifier: MIT
"""The realtime part; ``nctakt.mode`` decides in which form its modules are imported."""

from nctakt import mode as mode
