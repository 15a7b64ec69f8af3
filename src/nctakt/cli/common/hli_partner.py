# SPDX-License-Identifier: MIT
"""The PLC in another process at ``--hli``: waits of the CNC are reported as they happen.

In: a controller, the name of the shared memory. Out: the PLC, once it has connected; notes and
warnings on standard error while the CNC waits for it.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import Severity, Text
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.messages import diagnostic
from nctakt.messages.plcs.hli_connection import (
    PLC_ANSWERED_AGAIN,
    PLC_CONNECTED,
    PLC_KEEPS_WAITING,
    WAITING_FOR_PLC,
)

#: Checks without a pause: a partner on another core answers within some microseconds.
_EAGER_LOOKS = 50

#: The pause between two later checks, in seconds.
_PAUSE_S = 0.0001


def waiter(seconds: float) -> Callable[[Callable[[], bool]], bool]:
    """Return a function that waits for a condition and returns whether it came true in time."""

    def wait(condition: Callable[[], bool]) -> bool:
        for _ in range(_EAGER_LOOKS):
            if condition():
                return True
            time.sleep(0)
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                return False
            time.sleep(_PAUSE_S)
        return True

    return wait


if TYPE_CHECKING:
    from collections.abc import Callable

    from nctakt.base.diagnostics import Diagnostic
    from nctakt.cli.common.request import Options
    from nctakt.plc import PartnerPlc
    from nctakt.run.access.shared_image import SharedImage
    from nctakt.run.controller import Controller

#: Time limits in seconds for a PLC in another process: to appear, and to answer a tick.
_COMES_S = 30.0
_ANSWERS_S = 10.0

#: The time in seconds after which it is said that the CNC waits for an answer.
_PATIENCE_S = 1.0


def connect_partner(
    options: Options, name: str, controller: Controller, files: contextlib.ExitStack
) -> PartnerPlc:
    """Return the PLC that has connected; raises ``PlcError`` (900650) if none comes in time."""
    from nctakt.plc import PartnerPlc  # noqa: PLC0415 - the mode is chosen before its import

    image = files.enter_context(controller.interface_image(name))
    patience = _Patience(options, controller)
    patience.show(diagnostic(WAITING_FOR_PLC, name=name, seconds=f"{_COMES_S:g}"))
    PartnerPlc(image, waiter(_COMES_S)).await_presence()
    patience.show(diagnostic(PLC_CONNECTED, name=name, process=_process_of(image, options)))
    partner = PartnerPlc(image, patience.wait)
    files.callback(partner.close)
    return partner


class _Patience:
    """Waits for the answers of a PLC and says so when one takes long."""

    def __init__(self, options: Options, controller: Controller) -> None:
        self._options = options
        self._controller = controller
        self._patient = waiter(_PATIENCE_S)
        self._further = waiter(_ANSWERS_S - _PATIENCE_S)

    def wait(self, condition: Callable[[], bool]) -> bool:
        """Return whether the condition came true in time."""
        if self._patient(condition):
            return True
        tick = self._controller.tick - 1
        waited, left = f"{_PATIENCE_S:g}", f"{_ANSWERS_S - _PATIENCE_S:g}"
        self.show(diagnostic(PLC_KEEPS_WAITING, tick=tick, seconds=waited, left=left))
        is_answered = self._further(condition)
        if is_answered:
            self.show(diagnostic(PLC_ANSWERED_AGAIN, tick=tick))
        return is_answered

    def show(self, found: Diagnostic) -> None:
        """Show a diagnostic, a note unless the user wants quiet."""
        lowest = Severity.WARNING if self._options.quiet else Severity.NOTE
        print_diagnostics([found], self._options.language, lowest)


def _process_of(image: SharedImage, options: Options) -> str:
    """Return the PLC's process as shown."""
    process = image.plc_process
    shown = Text(f"process {process}", f"Prozess {process}")
    silent = Text("it does not name its process", "sie nennt ihren Prozess nicht")
    return (shown if process else silent).get(options.language)
