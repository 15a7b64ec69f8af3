# SPDX-License-Identifier: MIT
"""The operator's side of a channel by names: override, keys and lamps.

In: a way to read and write values of the HLI. Out: properties, the same for a scripted PLC
(``run/plcs/plc_view.py``) and for one in another process (``plc_side.py``).
"""

from __future__ import annotations

import math

#: The states of a channel in the order of their numbers.
STATES = ("ready", "running", "error", "reset")

#: The states of backward motion on the path, in the order of their numbers.
RETRACES = ("front", "backward", "forward")


class OperatorPanel:
    """The operator's values of one channel; derived classes read and write them."""

    __slots__ = ()

    def read(self, name: str) -> float | bool | str:
        """Return a value of the HLI or a variable; raises ``Failure`` for an unknown name."""
        raise NotImplementedError

    def write(self, name: str, value: float | bool | str) -> None:
        """Write a value of the HLI or a variable; raises ``Failure`` for a wrong one."""
        raise NotImplementedError

    @property
    def override_pct(self) -> float:
        """The operator's override of the path in percent."""
        return float(self.read("HLI.OVERRIDE"))

    @override_pct.setter
    def override_pct(self, value: float) -> None:
        if not 0.0 <= value < math.inf:
            raise ValueError(f"an override of {value} % is not possible")
        self.write("HLI.OVERRIDE", value)

    @property
    def feed_hold(self) -> bool:
        """Whether the path is held."""
        return bool(self.read("HLI.FEED_HOLD"))

    @feed_hold.setter
    def feed_hold(self, value: bool) -> None:
        self.write("HLI.FEED_HOLD", value)

    @property
    def single_block(self) -> bool:
        """Whether the channel stops before each block (MO-6)."""
        return bool(self.read("HLI.SINGLE_BLOCK"))

    @single_block.setter
    def single_block(self, value: bool) -> None:
        self.write("HLI.SINGLE_BLOCK", value)

    @property
    def optional_stop(self) -> bool:
        """Whether M01 stops the program as M00 does."""
        return bool(self.read("HLI.OPTIONAL_STOP"))

    @optional_stop.setter
    def optional_stop(self, value: bool) -> None:
        self.write("HLI.OPTIONAL_STOP", value)

    @property
    def backward_motion(self) -> bool:
        """Whether backward motion on the path is commanded (MO-7)."""
        return bool(self.read("HLI.BACKWARD_MOTION"))

    @backward_motion.setter
    def backward_motion(self, value: bool) -> None:
        self.write("HLI.BACKWARD_MOTION", value)

    @property
    def search_block(self) -> int:
        """The N number to which block search goes when a program begins; 0: from its beginning."""
        is_on = int(self.read("HLI.SEARCH_TYPE")) != 0
        return int(self.read("HLI.SEARCH_BLOCK")) if is_on else 0

    @search_block.setter
    def search_block(self, value: int) -> None:
        self.write("HLI.SEARCH_BLOCK", value)
        self.write("HLI.SEARCH_TYPE", 4 if value else 0)

    @property
    def retrace(self) -> str:
        """Backward motion on the path: ``front``, or in the history ``backward`` or ``forward``."""
        return RETRACES[int(self.read("HLI.RETRACE"))]

    @property
    def history(self) -> int:
        """The number of blocks in the history of the path."""
        return int(self.read("HLI.HISTORY"))

    @property
    def history_size(self) -> int:
        """The maximum number of blocks in the history (P-STUP-00033)."""
        return int(self.read("HLI.HISTORY_SIZE"))

    def start(self) -> None:
        """Press START: the selected program begins, or continues after M00 or single block."""
        self.write("HLI.START", 1.0)

    def reset(self) -> None:
        """Press RESET: the program is aborted, the path brakes to a standstill (RC-007)."""
        self.write("HLI.RESET", 1.0)

    @property
    def state(self) -> str:
        """The state of the channel: ``ready``, ``running``, ``error`` or ``reset``."""
        return STATES[int(self.read("HLI.STATE"))]

    @property
    def is_paused(self) -> bool:
        """Whether single block, M00 or M01 waits for START."""
        return bool(self.read("HLI.PAUSED"))

    @property
    def is_armed(self) -> bool:
        """Whether a selected program waits for START."""
        return bool(self.read("HLI.ARMED"))

    @property
    def error(self) -> int:
        """The number of the error that has stopped the channel, 0 without one."""
        return int(self.read("HLI.ERROR"))


#: The attributes that a PLC may set.
SETTABLE = tuple(
    name
    for name, value in vars(OperatorPanel).items()
    if isinstance(value, property) and value.fset is not None
)
