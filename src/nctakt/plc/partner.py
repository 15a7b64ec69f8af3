# SPDX-License-Identifier: MIT
"""A PLC in another process, in step with the CNC: both see the HLI in shared memory.

After each tick it is the PLC's turn: the CNC increments ``turn`` of the header and waits until the
PLC has written the same number into ``turn`` of the link. So a run has the same results however
fast the processes are, and the PLC's answers count from the next tick on (RC-002), as those of a
scripted one. The caller passes the function that waits: this module reads no clock.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from nctakt.hli.process_watch import ProcessWatch
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc import NO_PLC_AT_HLI, PLC_LEFT_HLI, PLC_NOT_ANSWERING
from nctakt.plc.error import PlcError

if TYPE_CHECKING:
    from nctakt.run.access.shared_image import SharedImage
    from nctakt.run.plcs.plc_view import PlcView

#: Waits until a condition is true; returns False if that takes too long.
Wait = Callable[[Callable[[], bool]], bool]


class PartnerPlc:
    """A PLC in another process that works with ``image``.

    ``cycle`` raises ``PlcError`` if it does not answer in time (900651) or has gone (900652): it
    reports that, or its process has ended.
    """

    def __init__(self, image: SharedImage, wait: Wait) -> None:
        self._image = image
        self._wait = wait
        image.announce_lockstep()
        self._process: ProcessWatch | None = None

    def await_presence(self) -> None:
        """Wait until the PLC is present; raises ``PlcError`` (900650) if none comes."""
        if not self._wait(lambda: self._image.plc_is_present):
            raise PlcError(diagnostic(NO_PLC_AT_HLI, name=self._image.name or ""))

    def cycle(self, hli: PlcView) -> None:
        """Let the PLC have its turn."""
        image = self._image
        process = self._process or ProcessWatch(image.plc_process)
        self._process = process
        image.hand_over()
        if not self._wait(lambda: image.is_handed_back or _is_gone(image, process)):
            raise PlcError(diagnostic(PLC_NOT_ANSWERING, tick=hli.tick))
        if not image.is_handed_back:
            raise PlcError(diagnostic(PLC_LEFT_HLI, tick=hli.tick))

    def close(self) -> None:
        """End the watch of the PLC's process."""
        if self._process is not None:
            self._process.close()


def _is_gone(image: SharedImage, process: ProcessWatch) -> bool:
    """Return whether the PLC reports that it has gone, or its process has ended."""
    return not image.plc_is_present or process.is_gone
