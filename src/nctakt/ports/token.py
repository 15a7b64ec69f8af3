# SPDX-License-Identifier: MIT
"""The token of a port: a secret that its command prints, and keeps in a file of its user alone.

Anyone who reaches a port of this computer, another user or a page in a browser, could command the
program there; only somebody who can read the file, or the terminal, knows the token.
"""

from __future__ import annotations

import contextlib
import hmac
import os
import secrets
import stat
import tempfile
from pathlib import Path

_BYTES = 24

#: The longest text that is read of a file of a token.
_MAX_LENGTH = 256


def new_token() -> str:
    """Return a new secret of hexadecimal digits: no ``-`` that a command takes for an option."""
    return secrets.token_hex(_BYTES)


def is_same(given: str, token: str) -> bool:
    """Return whether a client has given the token; it takes the same time for each wrong one."""
    return hmac.compare_digest(given.encode("utf-8", "replace"), token.encode())


class TokenFile:
    """The file of a token, readable by its user alone, until ``remove``; raises ``OSError``."""

    def __init__(self, kind: str, port: int, token: str) -> None:
        self.path = _folder() / f"{kind}-{port}.token"
        number, name = tempfile.mkstemp(dir=self.path.parent)  # of mode 600
        with os.fdopen(number, "w", encoding="ascii") as file:
            file.write(f"{token}\n")
        Path(name).replace(self.path)

    def remove(self) -> None:
        """Remove it: the port is closed."""
        with contextlib.suppress(OSError):
            self.path.unlink()


def known_token(kind: str, port: int) -> str | None:
    """Return the token of a port that a command of this user has opened, ``None`` without."""
    try:
        with (_folder() / f"{kind}-{port}.token").open(encoding="ascii") as file:
            return file.read(_MAX_LENGTH).strip() or None
    except (OSError, ValueError):
        return None


def _folder() -> Path:
    """Return the folder of such files, which is of this user alone; raises ``OSError``."""
    given = os.environ.get("XDG_RUNTIME_DIR")
    if os.name != "posix":
        folder = Path(tempfile.gettempdir()) / "nctakt"  # the system keeps it from other users
        folder.mkdir(exist_ok=True)
        return folder
    user = os.getuid()
    folder = Path(given) / "nctakt" if given else Path(tempfile.gettempdir()) / f"nctakt-{user}"
    folder.mkdir(mode=0o700, exist_ok=True)
    state = folder.lstat()
    if not stat.S_ISDIR(state.st_mode) or state.st_uid != user or state.st_mode & 0o077:
        raise PermissionError(0, f"{folder} is not a folder of this user alone")
    return folder
