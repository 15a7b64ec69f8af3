# SPDX-License-Identifier: MIT
"""Opens a machine's log: the format is recognised by the content of the file."""

from __future__ import annotations

import codecs
from collections.abc import Mapping
from pathlib import Path

from nctakt.base.failure import Failure
from nctakt.comparison.log import Log
from nctakt.comparison.measurement_files import Mf4Log, ParquetLog, TraceLines
from nctakt.comparison.plain_table import PlainTable
from nctakt.comparison.scope_export import ScopeExport, is_scope_export
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import LOG_IN_OTHER_FORM, LOG_NOT_UTF8
from nctakt.results.trace.sinks import PARQUET

_MARKS = {
    codecs.BOM_UTF8: "utf-8-sig",
    codecs.BOM_UTF16_LE: "utf-16",
    codecs.BOM_UTF16_BE: "utf-16",
}
#: Suffixes of known forms that are not read, and how to get one that is.
_OTHER_FORMS = (".svdx", ".svd", ".svb", ".tcscopex", ".xml", ".tdms")


def open_log(path: str | Path, access: FileAccess, said: Mapping[str, str] | None = None) -> Log:
    """Return the log of a file; ``said``: its section of the mapping file.

    Raises ``Failure`` for a file that cannot be read, and a form that is not known (902510).
    """
    path = Path(path)
    begin = access.read_begin(path)
    if path.suffix.lower() in (".mf4", ".mdf"):
        return Mf4Log(path)
    if path.suffix.lower() == PARQUET:
        return ParquetLog(path, said or {})
    if begin.startswith(b"{"):
        return TraceLines(path, access)
    encoding = next((name for mark, name in _MARKS.items() if begin.startswith(mark)), "")
    if not encoding and begin[1:2] == b"\0" != begin[:1]:
        encoding = "utf-16-le"  # without a mark: a name begins with a letter of ASCII
    if path.suffix.lower() in _OTHER_FORMS or (b"\0" in begin and "16" not in encoding):
        raise Failure(diagnostic(LOG_IN_OTHER_FORM, file=str(path)))
    is_guessed = not encoding and not _is_utf8(begin)
    encoding = encoding or ("cp1252" if is_guessed else "utf-8")
    text = begin.decode(encoding, "replace").lstrip("\ufeff")
    if is_scope_export(text):
        log: Log = ScopeExport(path, access, encoding)
    else:
        log = PlainTable(path, access, encoding, said or {})
    if is_guessed:
        log.notes.append(diagnostic(LOG_NOT_UTF8, file=str(path)))
    return log


def _is_utf8(begin: bytes) -> bool:
    """Return whether the beginning of a file is UTF-8; a character at its end may be cut."""
    return not codecs.getincrementaldecoder("utf-8")("replace").decode(begin).count("\ufffd")
