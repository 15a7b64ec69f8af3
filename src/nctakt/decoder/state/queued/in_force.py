# SPDX-License-Identifier: MIT
"""The settings in force in a block: the modal G functions, the zero offset and the tool."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.decoder.state.queued.commands import Command
from nctakt.kernel import rows
from nctakt.nc.vocabulary.functions import NUMBERED_ZERO_OFFSET, ZERO_OFFSETS


@dataclass(frozen=True, slots=True)
class InForce:
    """``functions``: the modal G functions in ascending order; ``tool``: the latest T, 0 without.

    A zero offset that G159 selects is among the functions as 159.
    """

    functions: tuple[int, ...]
    tool: int

    @property
    def zero_offset(self) -> int:
        """The function that selects the zero offsets: 53 … 59 or 159."""
        for function in self.functions:
            if function in ZERO_OFFSETS or function == NUMBERED_ZERO_OFFSET:
                return function
        return ZERO_OFFSETS[0]


@dataclass(frozen=True, slots=True)
class ModalMark(Command):
    """Something else is in force from here on; ``modal``: its number."""

    packed_as = rows.MODAL_MARK

    modal: int
