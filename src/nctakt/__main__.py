# SPDX-License-Identifier: MIT
"""``python -m nctakt`` is the command ``nctakt``."""

import sys

from nctakt.base.python_process import leave_working_directory

leave_working_directory()  # before the libraries that the command imports
import signal  # noqa: E402 - a file of this name in the working directory must not run


def start() -> int:
    """Run the command and return its exit code.

    Before it begins, and once it is over, Ctrl-C ends the process as the system does: nothing is
    there to be kept, and Python would show a traceback. Where it is ignored it stays ignored.
    """
    answer = signal.getsignal(signal.SIGINT)
    quiet = signal.SIG_DFL if answer == signal.default_int_handler else answer
    signal.signal(signal.SIGINT, quiet)
    from nctakt.cli import main  # noqa: PLC0415 - the import takes most of the time of a start

    signal.signal(signal.SIGINT, answer)
    try:
        return main()
    finally:
        signal.signal(signal.SIGINT, quiet)


if __name__ == "__main__":
    sys.exit(start())
