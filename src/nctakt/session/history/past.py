# SPDX-License-Identifier: MIT
"""The past of a session, to be run once more and explained: why reactions fired, or did not.

The session itself keeps no histories of conditions, since they cost time in each tick.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.run.access.inputs import PLC, Input
from nctakt.session.history.branch import Branch
from nctakt.session.history.record import PastMark
from nctakt.session.setup import Setup


@dataclass(frozen=True, slots=True)
class Past:
    """Everything needed to rerun a branch of a session up to a tick, in a separate process.

    ``marks``: those that this must lead to.
    """

    setup: Setup
    branch: Branch
    inputs: tuple[Input, ...]
    tick: int
    marks: tuple[PastMark, ...]

    def inputs_from(self, tick: int) -> list[Input]:
        """Return the inputs that a controller before a tick has not had yet.

        The PLC's output of the previous tick is in its state.
        """
        return [one for one in self.inputs if one.tick >= tick + (tick > 0 and one.source == PLC)]
