# SPDX-License-Identifier: MIT
"""``python -m nctakt`` is the command ``nctakt``."""

import sys

if __name__ == "__main__" and not sys.flags.safe_path:
    del sys.path[0]  # ``python -m`` has put the working directory there: none of its files runs
# ``signal`` reads other modules first, in which Ctrl-C would show a traceback; this one is built in
import _signal  # type: ignore[import-not-found]


def start() -> int:
    """Run the command and return its exit code.

    Before it begins, and once it is over, Ctrl-C ends the process as the system does: nothing is
    there to be kept, and Python would show a traceback. Where it is ignored it stays ignored.
    """
    answer = _signal.getsignal(_signal.SIGINT)
    quiet = _signal.SIG_DFL if answer == _signal.default_int_handler else answer
    _signal.signal(_signal.SIGINT, quiet)
    from nctakt.cli import main  # noqa: PLC0415 - the import takes most of the time of a start

    _signal.signal(_signal.SIGINT, answer)
    try:
        return main()
    finally:
        _signal.signal(_signal.SIGINT, quiet)


if __name__ == "__main__":
    sys.exit(start())
