# SPDX-License-Identifier: MIT
"""A new folder of files: all of them or none.

In: a folder that is not there or empty, contents by name (``machine/axis.lis``). Out: the files. If
one cannot be written, those before it are removed again.
"""

from __future__ import annotations

import contextlib
from collections.abc import Mapping
from pathlib import Path

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.machines.folders import FOLDER_NOT_EMPTY, FOLDER_NOT_WRITABLE


def check_new_folder(folder: Path) -> None:
    """Raise ``Failure`` for a folder in use or a file of its name."""
    try:
        if folder.exists() and any(folder.iterdir()):
            raise Failure(diagnostic(FOLDER_NOT_EMPTY, folder=str(folder)))
    except OSError as error:
        raise _not_writable(folder, error) from error


def write_new_folder(folder: Path, files: Mapping[str, bytes]) -> None:
    """Write the files; raises ``Failure`` if the folder is in use or cannot be written."""
    check_new_folder(folder)
    needed = dict.fromkeys((folder / name).parent for name in files)
    on_path = dict.fromkeys(above for one in needed for above in (one, *one.parents))
    new_folders = sorted((one for one in on_path if not one.exists()), key=_depth, reverse=True)
    written: list[Path] = []
    try:
        try:
            for name, data in files.items():
                path = folder / name
                path.parent.mkdir(parents=True, exist_ok=True)
                with path.open("xb") as file:
                    written.append(path)
                    file.write(data)
        except BaseException:  # a full disk, Ctrl-C: half a machine is none
            _remove(written, new_folders)
            raise
    except OSError as error:
        raise _not_writable(folder, error) from error


def _depth(folder: Path) -> int:
    return len(folder.parts)


def _not_writable(folder: Path, error: OSError) -> Failure:
    reason = error.strerror or str(error)
    return Failure(diagnostic(FOLDER_NOT_WRITABLE, folder=str(folder), reason=reason))


def _remove(files: list[Path], folders: list[Path]) -> None:
    """Remove files and the folders that were made for them, the deepest first."""
    with contextlib.suppress(OSError):
        for file in files:
            file.unlink()
        for folder in folders:
            folder.rmdir()
