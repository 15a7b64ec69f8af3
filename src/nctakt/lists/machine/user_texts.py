# SPDX-License-Identifier: MIT
"""The texts of user-defined errors (P-STUP-00169): lines of a number and its text.

In: the bytes of the file. Out: number -> text. Empty lines and comments that begin with ``#`` are
skipped; a line that is not a number from 1 to 1000 with a text is reported.
"""

from __future__ import annotations

import re

from nctakt.base.text import decode_text, split_lines
from nctakt.files.access import FileAccess
from nctakt.lists.machine.files import ListSearch, read_file
from nctakt.messages import Collector
from nctakt.messages.programs.user_errors import INVALID_USER_TEXT_LINE, USER_TEXTS_MISSING

HIGHEST_ID = 1000

_LINE = re.compile(r"\s*(\d{1,4})\s+(\S.*?)\s*$")


def user_texts(
    path: str, search: ListSearch, access: FileAccess, collector: Collector
) -> dict[int, str]:
    """Return the texts of the file that the start-up list names, none without one."""
    if not path:
        return {}
    file = search.find(path)
    if file is None:
        collector.report(USER_TEXTS_MISSING, None, path=path)
        return {}
    data = read_file(file, access, collector)
    return {} if data is None else _texts(data, path, collector)


def _texts(data: bytes, name: str, collector: Collector) -> dict[int, str]:
    texts: dict[int, str] = {}
    for number, line in enumerate(split_lines(decode_text(data).text), 1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        match = _LINE.match(line)
        if match is None or not 1 <= int(match[1]) <= HIGHEST_ID:
            collector.report(INVALID_USER_TEXT_LINE, None, file=name, line=number)
            continue
        texts[int(match[1])] = match[2]
    return texts
