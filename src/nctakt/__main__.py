# SPDX-License-Identifier: MIT
"""``python -m nctakt`` is the command ``nctakt``."""

import sys

from nctakt.cli import main

if __name__ == "__main__":
    sys.exit(main())
