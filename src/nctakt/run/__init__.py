# SPDX-License-Identifier: MIT
"""A controller and its runs: assembly, programs, the loop between decoder and kernel."""

from nctakt.base import mode as mode
