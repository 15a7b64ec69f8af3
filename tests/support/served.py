# SPDX-License-Identifier: MIT
"""A session served by OPC UA in its own thread, for clients of any kind."""

from __future__ import annotations

import asyncio
import json
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from nctakt import Session
from nctakt.lists.machine.machine import load_machine
from nctakt.plc.structured_text import structured_programs
from nctakt.servers.host import Host
from nctakt.servers.log import ServerLog
from nctakt.servers.opcua.endpoint import OpcuaEndpoint
from nctakt.servers.opcua.limits import Limits

PROGRAM = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.E.VALUE > 0.5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
#MSG ["begun"]
S1000 M3
N10 G01 X100 Y20 F6000
$WHILE V.E.FLAG == 0
N20 G04 X0.05
$ENDWHILE
N30 G01 X0
M30
"""

WRONG = "G01 X10 F6000\nG01 X100000\nM30\n"


class Served:
    """A session and its endpoint; ``url``: its address. ``step`` runs ticks while it pauses."""

    def __init__(
        self,
        folder: Path,
        *,
        address: str = "127.0.0.1",
        limits: Limits | None = None,
        text: str = PROGRAM,
        plc: Path | None = None,
    ) -> None:
        self.folder = folder
        self.lines: list[dict[str, Any]] = []
        (folder / "part.nc").write_text(text, encoding="utf-8")
        (folder / "wrong.nc").write_text(WRONG, encoding="utf-8")
        (folder / "other.nc").write_text("G01 X5 F6000\nM30\n", encoding="utf-8")
        self.session = Session(
            str(folder / "part.nc"),
            stays=True,
            wait_for_start=True,
            folders=[str(folder)],
            plc=plc,
        )
        self._programs = [] if plc is None else structured_programs(plc)
        self._address = address
        self._limits = limits
        self._ready = threading.Event()
        self._thread = threading.Thread(target=lambda: asyncio.run(self._serve()), daemon=True)
        self.failure: Exception | None = None
        self._thread.start()
        assert self._ready.wait(60)
        if self.failure is not None:
            raise self.failure

    async def _serve(self) -> None:
        self._loop = asyncio.get_running_loop()
        self._end = asyncio.Event()
        log = ServerLog(lambda line: self.lines.append(json.loads(line)))
        try:
            self.host = await Host(self.session, load_machine(), log, self._programs).open()
            address = self._address, 0
            self.endpoint = OpcuaEndpoint(self.host, address, self.folder / "opcua", self._limits)
            await self.endpoint.prepare()
            self.url = await self.endpoint.open()
        except Exception as error:  # noqa: BLE001 - the thread of the test raises it
            self.failure = error
            return
        finally:
            self._ready.set()
        await self._end.wait()
        await self.endpoint.close()
        await self.host.close()

    def refusals(self) -> list[str]:
        """Return the reasons for which clients were refused something."""
        return [line.get("reason", "") for line in self.lines if line["event"] == "refused"]

    def close(self) -> None:
        """End it."""
        if self._thread.is_alive():
            self._loop.call_soon_threadsafe(self._end.set)
            self._thread.join(60)
        self.session.close()


#: How long a client waits for an answer: four seconds, as by itself, pass on a busy machine.
PATIENCE_S = 60.0


async def until(condition: Callable[[], Any], deadline_s: float = 60.0) -> Any:
    """Return what a condition gives once it is true; fail after a time."""
    end = time.monotonic() + deadline_s
    while True:
        found = condition()
        if asyncio.iscoroutine(found):
            found = await found
        if found:
            return found
        assert time.monotonic() < end, "it never came"
        await asyncio.sleep(0.01)
