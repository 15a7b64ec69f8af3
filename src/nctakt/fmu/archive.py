# SPDX-License-Identifier: MIT
"""The file of an FMU, a zip archive: its description as text, its files in a separate folder.

Nothing is written outside that folder, and the unpacked size is bounded.
"""

from __future__ import annotations

import stat
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from nctakt.files.access import FileAccess
from nctakt.fmu.failures import FmuError
from nctakt.messages import diagnostic
from nctakt.messages.plcs.fmu import FMU_NOT_READABLE, FMU_PATH_OUTSIDE

#: Bytes of an unpacked FMU, of its description, and the number of its files.
_MAX_BYTES = 1 << 30
_MAX_DESCRIPTION_BYTES = 64 << 20
_MAX_FILES = 20_000

_DESCRIPTION = "modelDescription.xml"


def not_readable(file: Path, reason: object) -> FmuError:
    """Return the failure of a file that is no FMU (902601)."""
    return FmuError(diagnostic(FMU_NOT_READABLE, file=str(file), reason=reason))


@contextmanager
def _opened(file: Path) -> Iterator[zipfile.ZipFile]:
    """Open the archive; raises ``FmuError`` for one that cannot be read or leaves its folder."""
    try:
        with zipfile.ZipFile(file) as archive:
            _check_entries(file, archive)
            yield archive
    except (OSError, zipfile.BadZipFile, NotImplementedError, RuntimeError, EOFError) as error:
        raise not_readable(file, error) from error


def _check_entries(file: Path, archive: zipfile.ZipFile) -> None:
    entries = archive.infolist()
    for entry in entries:
        name = entry.orig_filename
        is_link = stat.S_ISLNK(entry.external_attr >> 16)
        parts = name.replace("\\", "/").split("/")
        if is_link or ":" in name or "\\" in name or "\0" in name or ".." in parts or not parts[0]:
            raise FmuError(diagnostic(FMU_PATH_OUTSIDE, file=str(file), path=name))
    if len(entries) > _MAX_FILES or sum(entry.file_size for entry in entries) > _MAX_BYTES:
        raise not_readable(file, f"more than {_MAX_FILES} files or {_MAX_BYTES >> 20} MiB")


def read_description(file: Path, access: FileAccess) -> bytes:
    """Return the text of the description; raises ``FmuError``, ``Failure`` without access."""
    access.check_admitted(file)
    with _opened(file) as archive:
        names = archive.namelist()
        if _DESCRIPTION not in names:
            raise not_readable(file, f"it has no {_DESCRIPTION}")
        if archive.getinfo(_DESCRIPTION).file_size > _MAX_DESCRIPTION_BYTES:
            raise not_readable(file, f"{_DESCRIPTION} has more than 64 MiB")
        text = archive.read(_DESCRIPTION)
    try:
        text.decode("utf-8")  # as FMI asks: in another encoding the next check would see nothing
    except UnicodeDecodeError:
        raise not_readable(file, f"{_DESCRIPTION} is not UTF-8") from None
    if b"<!DOCTYPE" in text:
        raise not_readable(file, f"{_DESCRIPTION} declares a document type")
    return text


def platforms_of(file: Path) -> list[str]:
    """Return the platforms for which an FMU has libraries, sorted."""
    with _opened(file) as archive:
        parts = [name.split("/") for name in archive.namelist()]
    return sorted({part[1] for part in parts if len(part) > 2 and part[0] == "binaries"})


def unpack(file: Path, folder: Path) -> None:
    """Write the files of an FMU into a folder; raises ``FmuError``."""
    with _opened(file) as archive:
        archive.extractall(folder)
