# SPDX-License-Identifier: MIT
"""The setup of a session, and facts about its machine known before the first tick."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic
from nctakt.nc.tree import RealtimeCycle
from nctakt.run.access.inputs import Input
from nctakt.run.options import RunKeywords
from nctakt.run.program_loader import NcText


@dataclass(frozen=True, slots=True)
class Setup:
    """Programs, machine and PLC of a session.

    ``programs``: number of the channel, from 1 -> its programs. ``machine``: a folder, ``None`` for
    the demo machine. ``plc``: files of PLCs. ``acknowledges``: technology functions acknowledge
    themselves if no PLC is present; else a user of the session, or a tape, does it. ``folders``:
    the only ones whose files may be read, if any are given. ``inputs``: those of a tape;
    ``is_replay``: with what Python did for the PLC. ``rtconf``: a scheduling list by which the
    controller's threads run on a real clock, with its ``load`` and the name of its operating
    system. ``options``: those of ``Controller.run``, of
    which ``signals`` are by default those of a run and the variables of the machine.
    """

    programs: Mapping[int, Sequence[str | Path | NcText]]
    machine: str | Path | None = None
    plc: str | Path | Sequence[str | Path] | None = None
    acknowledges: bool = True
    folders: Sequence[str | Path] = ()
    inputs: Sequence[Input] = ()
    is_replay: bool = False
    rtconf: str | None = None
    load: str | None = None
    system: str | None = None
    options: RunKeywords = field(default_factory=RunKeywords)

    @property
    def plcs(self) -> tuple[str | Path, ...]:
        """The files of the PLCs."""
        if self.plc is None:
            return ()
        return (self.plc,) if isinstance(self.plc, str | Path) else tuple(self.plc)


@dataclass(frozen=True, slots=True)
class Inventory:
    """Names available to programs of a machine, and the realtime cycles in their texts.

    ``variables``: number of the channel -> V.E, V.CH, V.RTA and V.RTG by name with their types;
    those of V.RTA and V.RTG have none.
    """

    variables: Mapping[int, Mapping[str, str]]
    cycles: tuple[RealtimeCycle, ...]


@dataclass(frozen=True, slots=True)
class Description:
    """A machine with its checked programs before the first tick.

    ``signals``: name -> unit; ``booleans``: those that are true or false. ``texts``: file -> its
    lines. ``inputs``: those that the setup has planned. ``is_over``: the programs have errors.
    """

    cycle_time_us: int
    channel_count: int
    signals: Mapping[str, str]
    texts: Mapping[str, Sequence[str]]
    diagnostics: Sequence[Diagnostic]
    inputs: Sequence[Input]
    is_over: bool
    #: The files of a PLC in Structured Text with their lines, and where statements begin in them.
    plc_texts: Mapping[str, Sequence[str]] = field(default_factory=dict)
    plc_lines: Mapping[str, Sequence[int]] = field(default_factory=dict)
    booleans: frozenset[str] = frozenset()
