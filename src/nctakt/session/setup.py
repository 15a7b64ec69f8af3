# SPDX-License-Identifier: MIT
"""What a session is opened with, and what it knows of its machine before the first tick."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic
from nctakt.lists.format.times import TimeLike
from nctakt.nc.tree import RealtimeCycle
from nctakt.run.inputs import Input
from nctakt.run.program_loader import NcText
from nctakt.run.stimuli import StimulusLike


@dataclass(frozen=True, slots=True)
class Setup:
    """Programs, machine and PLC of a session.

    ``programs``: number of the channel, from 1 -> its programs. ``machine``: a folder, ``None`` for
    the demo machine. ``plc``: a Python file. ``acknowledges``: technology functions acknowledge
    themselves where there is no PLC; else whoever watches the session does it. ``folders``: the
    only ones whose files may be read, where there are any. ``inputs``: those of a tape. ``rtconf``:
    a scheduling list by which the controller's threads run on a real clock, with its ``load`` and
    the name of its operating system. ``signals``: those that the session records, by default those
    of a run and the variables of the machine. ``why`` and the rest, among them the start block of
    a block search, as in ``Controller.run``.
    """

    programs: Mapping[int, Sequence[str | Path | NcText]]
    machine: str | Path | None = None
    plc: str | Path | None = None
    set: Mapping[str, float | str] = field(default_factory=dict)
    at: Sequence[StimulusLike] = ()
    until: TimeLike | None = None
    after: TimeLike = 0
    wait_for_start: bool = False
    skip: Sequence[int] = ()
    acknowledges: bool = True
    folders: Sequence[str | Path] = ()
    why: bool = False
    stays: bool = False
    signals: Sequence[str] | None = None
    inputs: Sequence[Input] = ()
    rtconf: str | None = None
    load: str | None = None
    system: str | None = None
    from_line: int | None = None
    from_block: int | None = None


@dataclass(frozen=True, slots=True)
class Inventory:
    """What programs of a machine can name, and the realtime cycles in their texts.

    ``variables``: number of the channel -> V.E, V.CH, V.RTA and V.RTG by name with their types;
    those of V.RTA and V.RTG have none.
    """

    variables: Mapping[int, Mapping[str, str]]
    cycles: tuple[RealtimeCycle, ...]


@dataclass(frozen=True, slots=True)
class Description:
    """What a machine with its checked programs is before the first tick.

    ``signals``: name -> unit. ``texts``: file -> its lines. ``inputs``: those that the setup has
    planned. ``is_over``: the programs have errors.
    """

    cycle_time_us: int
    channel_count: int
    signals: Mapping[str, str]
    texts: Mapping[str, Sequence[str]]
    diagnostics: Sequence[Diagnostic]
    inputs: Sequence[Input]
    is_over: bool
