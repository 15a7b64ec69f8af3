# SPDX-License-Identifier: MIT
"""Saving parts of a run from the page: pictures, traces, the tape.

In: a session, up to the end of its branch. Out: a file, made by a replay of the branch's tape in a
separate process, so that it equals the output of ``nctakt run``.
"""

from __future__ import annotations

import contextlib
import subprocess
import tempfile
from functools import partial
from pathlib import Path

from nicegui import ui

from nctakt.base.failure import Failure
from nctakt.base.python_process import python_command, python_environment
from nctakt.live.parts.commander import Commander
from nctakt.live.parts.naming import explained
from nctakt.messages import diagnostic
from nctakt.messages.connections.live import RUN_NOT_SAVED
from nctakt.session.session import Session

#: The end of a file's name -> the option of ``nctakt replay`` that writes it.
KINDS = {
    "svg": "--plot",
    "png": "--plot",
    "html": "--plot",
    "csv": "--trace",
    "parquet": "--trace",
    "vcd": "--vcd",
    "json": "--perfetto",
    "tape": None,
}

#: Files that a browser may still be fetching.
_KEPT = 3


def save_run(session: Session, kind: str, path: Path) -> None:
    """Write the run of a session's branch; raises ``Failure`` (902700) where that cannot be.

    It may take as long as the run did.
    """
    option = KINDS[kind]
    if option is None:
        session.save(path)
        return
    tape = path.with_name("run.tape")
    session.save(tape)
    roots = [word for folder in session.folders for word in ("--root", str(folder))]
    words = [str(tape), option, str(path), "--quiet", *roots, "--root", str(path.parent)]
    done = subprocess.run(
        python_command("nctakt", "replay", *words),
        env=python_environment(),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        check=False,
        encoding="utf-8",
        errors="replace",
    )
    tape.unlink()
    if not path.exists():
        reason = next(iter(done.stderr.strip().splitlines()), f"nctakt replay: {done.returncode}")
        raise Failure(diagnostic(RUN_NOT_SAVED, kind=kind, reason=reason))


class Saving:
    """The menu of one browser that saves the run; built where it is created."""

    def __init__(self, commander: Commander) -> None:
        self._commander = commander
        self._is_busy = False
        self._folders: list[tempfile.TemporaryDirectory[str]] = []
        texts = commander.texts
        button = ui.button(icon="download").props("flat dense size=sm data-testid=save-run")
        explained(button, texts["save_run"])
        with button, ui.menu():
            for kind in KINDS:
                item = ui.menu_item(texts[f"save_{kind}"], partial(self._save, kind))
                item.props(f"role=menuitem data-testid=save-{kind}")

    async def _save(self, kind: str) -> None:
        """Make the file and let the browser fetch it."""
        shared, texts = self._commander.shared, self._commander.texts
        if self._is_busy or not shared.snapshot.latest:
            ui.notify(texts["saving" if self._is_busy else "not_run"])
            return
        self._is_busy = True
        folder = tempfile.TemporaryDirectory(prefix="nctakt-page-", ignore_cleanup_errors=True)
        path = Path(folder.name) / f"{Path(shared.channel.file).stem}.{kind}"
        ui.notify(texts["saving"], timeout=2000)
        try:
            session = shared.session
            if await self._commander.attempt(lambda: save_run(session, kind, path)):
                self._folders.append(folder)
                ui.download.file(path, path.name)
        finally:
            self._is_busy = False
            for old in self._folders[:-_KEPT]:
                with contextlib.suppress(OSError):
                    old.cleanup()
            del self._folders[:-_KEPT]
