# SPDX-License-Identifier: MIT
"""NC text -> checked program; ``nctakt.base.mode`` decides in which form its modules are
imported."""

from nctakt.base import mode as mode
