# SPDX-License-Identifier: MIT
"""NC text -> checked program; ``nctakt.mode`` decides in which form its modules are imported."""

from nctakt import mode as mode
