# SPDX-License-Identifier: MIT
"""Settings that may run code: those that nobody else can write, or of a trusted folder.

In: files that name code, or have it. Out: why they do not count. A project file in a parent folder
may be anybody's; it may run code only if the file, the code, modules that Python imports next to
it, and their folders belong to the user or to root and nobody else may write them, if the user
trusts the folder (a line in ``nctakt/trusted`` below the folder of the user's settings), or if he
trusts all of them for a command (``--trust``). Systems without owners in Python's sense (Windows)
are not asked.
"""

from __future__ import annotations

import contextlib
import os
import stat
import struct
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

from nctakt.base.diagnostics import Text
from nctakt.project.imports import with_imports

try:
    import grp
    import pwd
except ImportError:  # Windows
    grp = pwd = None  # type: ignore[assignment]

#: The variable with the folder of the user's settings, and the list in it.
_SETTINGS_VARIABLE, _LIST = "XDG_CONFIG_HOME", "nctakt/trusted"

#: Where Linux keeps the access list (ACL) of a file, and what its entries are (acl(5)).
_ACCESS_LIST, _ENTRY, _LISTED_USER, _LISTED_GROUP = "system.posix_acl_access", "<HHI", 2, 8

_is_all_trusted = False


@contextlib.contextmanager
def trusting() -> Iterator[None]:
    """Trust all projects meanwhile."""
    global _is_all_trusted  # noqa: PLW0603 - the user says it once for the process
    before, _is_all_trusted = _is_all_trusted, True
    try:
        yield
    finally:
        _is_all_trusted = before


def trusts_all() -> bool:
    """Return whether all projects are trusted at the moment."""
    return _is_all_trusted


def list_of_trusted() -> Path:
    """Return the file that names the trusted folders, one a line; it need not be there."""
    settings = os.environ.get(_SETTINGS_VARIABLE, "")
    folder = Path(settings) if settings else Path(os.path.expanduser("~/.config"))  # noqa: PTH111 - without a home it stays as it is
    return folder / _LIST


def why_distrusted(files: Iterable[Path], folder: Path) -> Text | None:
    """Return why files of a folder may not have code run; ``None`` if they may.

    ``folder``: of the project, which the user may trust. For a Python file its imports count, too.
    """
    if pwd is None or _is_all_trusted:
        return None
    reason = _first_reason(with_imports(files))
    if reason is None:
        return None
    trusted = list_of_trusted()
    try:
        lines = trusted.read_text("utf-8", errors="replace").splitlines()
    except OSError:
        return reason
    of_list = _first_reason([trusted])
    if of_list is not None:
        return of_list
    folder_path = os.path.realpath(folder)
    names = (line.strip() for line in lines)
    folders = (os.path.realpath(name) for name in names if Path(name).is_absolute())
    return None if any(Path(folder_path).is_relative_to(one) for one in folders) else reason


def _first_reason(files: Iterable[Path]) -> Text | None:
    """Return the problem with the first file, or its folder, that others own or may write."""
    for file in files:
        real = Path(os.path.realpath(file))
        for path in dict.fromkeys((file.absolute().parent, real.parent, real)):
            reason = _reason(path)
            if reason is not None:
                return reason
    return None


def _reason(path: Path) -> Text | None:
    try:
        state = path.stat()
    except OSError as error:
        text = error.strerror or str(error)
        return Text(f"{path}: {text}", f"{path}: {text}")
    owner = state.st_uid
    if owner not in _own_users():
        return Text(
            f"{path} belongs to {_user(owner)}", f"{path} gehört dem Benutzer {_user(owner)}"
        )
    is_shared = state.st_mode & stat.S_IWGRP and (_is_shared(state) or _is_listed(path))
    if state.st_mode & stat.S_IWOTH or is_shared:
        return Text(f"others may write {path}", f"andere dürfen {path} schreiben")
    return None


def _own_users() -> set[int]:
    """Return root and the user, with ``sudo`` the user who has called it."""
    users = {0, os.geteuid()}
    caller = os.environ.get("SUDO_UID", "")
    if os.geteuid() == 0 and caller.isascii() and caller.isdecimal():
        users.add(int(caller))
    return users


def _is_shared(state: os.stat_result) -> bool:
    """Return whether the group of a file has others than its owner in it.

    Many systems give each user a group of the same name, and let the group write.
    """
    if state.st_gid == 0:
        return False  # the group of root
    try:
        group = grp.getgrgid(state.st_gid)
    except KeyError:
        return True
    owner = _user(state.st_uid)
    return group.gr_name != owner or any(member != owner for member in group.gr_mem)


def _is_listed(path: Path) -> bool:
    """Return whether the access list of a file lets other users, or further groups, write it.

    A file that has one shows in its mode, as what its group may, what any in the list may.
    """
    if sys.platform != "linux":
        return False
    try:
        entries = os.getxattr(path, _ACCESS_LIST)[4:]  # after the version
    except OSError:  # it has none
        return False
    return any(
        tag == _LISTED_GROUP or (tag == _LISTED_USER and number not in _own_users())
        for tag, permissions, number in struct.iter_unpack(_ENTRY, entries)
        if permissions & stat.S_IWOTH
    )


def _user(number: int) -> str:
    try:
        return pwd.getpwuid(number).pw_name
    except KeyError:
        return str(number)
