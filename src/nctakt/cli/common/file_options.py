# SPDX-License-Identifier: MIT
"""The files that a command may read (``--confine``), and those open from its start.

In: the folders of the words. Out: a ``FileAccess`` that knows where standard input comes from and
where standard output and standard error go to.
"""

from __future__ import annotations

import contextlib
import os
import stat
import sys
from collections.abc import Sequence

from nctakt.base.failure import Failure
from nctakt.base.text import decode_text
from nctakt.files.access import FileAccess, read_stream


def file_access(confined: Sequence[str]) -> FileAccess:
    """Return the access of a command; standard streams that are plain files are in it."""
    access = FileAccess(confined)
    state = _plain_file(0)
    if state is not None:
        access.note_state(state, "<stdin>")
    for number, name in ((1, "standard output"), (2, "standard error")):
        state = _plain_file(number)
        if state is not None:
            with contextlib.suppress(Failure):  # both may go to the same file
                access.claim(state, name, name)
    return access


def _plain_file(number: int) -> os.stat_result | None:
    """Return the state of the file that a number has open, if it is a plain file."""
    try:
        state = os.fstat(number)
    except OSError:
        return None
    return state if stat.S_ISREG(state.st_mode) else None


def read_standard_input() -> str:
    """Return the text of standard input; raises ``Failure`` where it is too long (900915)."""
    if sys.stdin is None:
        return ""
    return decode_text(read_stream(sys.stdin.buffer, "<stdin>")).text
