# SPDX-License-Identifier: MIT
"""``python -m nctakt`` is the command ``nctakt``."""

import sys

from nctakt.base.python_process import leave_working_directory

leave_working_directory()  # before the libraries that the command imports

from nctakt.cli import main  # noqa: E402 - as above

if __name__ == "__main__":
    sys.exit(main())
