# SPDX-License-Identifier: MIT
"""A controller and what a run needs: assembly, programs, the loop between decoder and kernel."""

from nctakt.base import mode as mode
