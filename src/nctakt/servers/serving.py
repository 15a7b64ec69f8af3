# SPDX-License-Identifier: MIT
"""A session served through its endpoints until somebody ends it.

In: a session, its endpoints, a speed. Out: the addresses once all endpoints are open. SIGTERM and
Ctrl-C end it: the endpoints close first, each informing its clients.
"""

from __future__ import annotations

import asyncio
import contextlib
import gc
import signal
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from nctakt.base import interrupts
from nctakt.base.failure import Failure, error_text
from nctakt.lists.machine.machine import Machine
from nctakt.messages import diagnostic
from nctakt.messages.connections.servers import CONTROLLER_SILENT, CONTROLLER_STOPPED
from nctakt.servers.connections import provide_descriptors
from nctakt.servers.host import Endpoint, Host
from nctakt.servers.log import ServerLog
from nctakt.servers.notices import ServerNotice
from nctakt.session.growing_tape import GrowingTape
from nctakt.session.session import Session
from nctakt.st.program import Program

#: Makes an endpoint of a host.
EndpointOpener = Callable[[Host], Endpoint]

#: How long an endpoint may take to close, in seconds.
CLOSING_S = 5.0

#: How long the session may take to pause at the end, in seconds.
PAUSING_S = 5.0

#: How often a tape grows, in seconds, and how long it waits where it could not.
_GROWING_S, _RETRY_S = 1.0, 10.0

#: How long a thread may compute while the loop or the session is due, in seconds.
_SWITCH_S = 0.00005


async def serve(
    session: Session,
    machine: Machine,
    log: ServerLog,
    endpoints: Mapping[str, EndpointOpener],
    *,
    programs: Sequence[Program] = (),
    tape: GrowingTape | None = None,
    speed: float | None,
    ready: Callable[[Mapping[str, str]], None],
) -> None:
    """Serve until a signal comes; ``ready`` gets the address of each endpoint, ``tape`` grows.

    ``programs``: those of the session's PLC in Structured Text.

    Raises ``Failure`` for an address that cannot be used, and when the controller has stopped
    (901354), or does not answer at the end.
    """
    sys.setswitchinterval(_SWITCH_S)
    host = await Host(session, machine, log, programs).open()
    end = EndSignal(host)
    host.loop.set_exception_handler(lambda _, context: _report_library_error(log, context))
    opened: list[tuple[str, Endpoint]] = []
    growing: asyncio.Task[None] | None = None
    try:
        addresses: dict[str, str] = {}
        closed = {name: opener(host) for name, opener in endpoints.items()}
        provide_descriptors(sum(endpoint.max_connections for endpoint in closed.values()))
        for endpoint in closed.values():
            await endpoint.prepare()
        host.clock.begin(session.tick)
        for name, endpoint in closed.items():
            addresses[name] = await endpoint.open()
            opened.append((name, endpoint))
            log.note("open", endpoint=name, address=addresses[name])
        await host.ask(session.play, speed)
        ready(addresses)
        if tape is not None:
            growing = host.loop.create_task(_grow(tape, log))
        await end.wait()
    finally:
        if growing is not None:
            growing.cancel()
        host.notices.notify(ServerNotice("closing", host.store.tick, ""))
        for name, endpoint in reversed(opened):
            try:
                await asyncio.wait_for(endpoint.close(), CLOSING_S)
            except Exception as error:  # noqa: BLE001 - the other endpoints must close as well
                log.error("close", endpoint=name, reason=error_text(error) or repr(error))
        late, worst_s = session.lateness
        missed = host.missed_frames
        answers = await _pauses(host)
        await host.close(answers=answers)
        lateness = {"late_slices": late, "worst_lateness_ms": round(worst_s * 1000, 3)}
        log.report_counts()
        refused = dict(sorted(log.refused.items()))
        log.note("closed", tick=session.tick, missed_frames=missed, **lateness, refused=refused)
    if not answers:
        raise Failure(diagnostic(CONTROLLER_SILENT, seconds=f"{PAUSING_S:g}"))


def _report_library_error(log: ServerLog, context: Mapping[str, Any]) -> None:
    """Report an exception of a library in a task that is not awaited; the loop continues."""
    error = context.get("exception")
    text = error_text(error) if isinstance(error, Exception) else ""
    log.error("loop", reason=text or str(context.get("message", "")))


async def _grow(tape: GrowingTape, log: ServerLog) -> None:
    """Let a tape grow; if it cannot, as on a full disk, it restarts later."""
    while True:
        wait_s = _GROWING_S
        try:
            await asyncio.to_thread(tape.look)
        except Failure:
            return  # the session has ended
        except OSError as error:
            log.error("tape", file=str(tape.path), reason=error_text(error))
            wait_s = _RETRY_S
        await asyncio.sleep(wait_s)


async def _pauses(host: Host) -> bool:
    """Pause the session; return whether it answers. If not, its controller is killed."""
    host.session.interrupt()  # requests of clients, such as a long past, end soon
    pausing = asyncio.ensure_future(host.ask(host.session.pause))
    done, _ = await asyncio.wait((pausing,), timeout=PAUSING_S)
    if not done:
        host.session.abandon()
        await asyncio.wait((pausing,), timeout=PAUSING_S)
    with contextlib.suppress(Failure, asyncio.InvalidStateError):
        pausing.result()
    return bool(done)


class EndSignal:
    """Waits for SIGTERM, Ctrl-C or the end of the controller."""

    def __init__(self, host: Host) -> None:
        self._end = asyncio.Event()
        self._reason = ""
        self._host = host
        loop = asyncio.get_running_loop()
        for number in interrupts.numbers():
            try:
                loop.add_signal_handler(number, self._end.set)
            except (NotImplementedError, RuntimeError, ValueError):  # Windows, or another thread
                with contextlib.suppress(ValueError):
                    signal.signal(number, lambda *_: loop.call_soon_threadsafe(self._end.set))
        host.notices.listen(self._watch_controller)

    def _watch_controller(self, notice: ServerNotice) -> None:
        """End when a slice has failed: the session does not continue."""
        if notice.kind in ("refused", "closed") and not self._host.session.is_playing:
            self._reason = notice.text
            self._end.set()

    async def wait(self) -> None:
        """Return when it shall end; raises ``Failure`` if the controller has stopped."""
        await self._end.wait()
        if self._reason:
            raise Failure(diagnostic(CONTROLLER_STOPPED, reason=self._reason))


@contextlib.contextmanager
def building() -> Iterator[Callable[[], None]]:
    """Let the garbage collector wait until the function that it gives is called.

    From then on it scans only later objects; at the end everything is as before. Otherwise it would
    scan half a million nodes and types again and again, a quarter of a second each time: three
    quarters of a start with OPC UA, and later the longest wait of a client.
    """
    was_enabled = gc.isenabled()
    gc.disable()

    def built() -> None:
        gc.freeze()
        gc.enable()

    try:
        yield built
    finally:
        gc.unfreeze()
        if was_enabled:
            gc.enable()
        else:
            gc.disable()
