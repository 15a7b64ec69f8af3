# SPDX-License-Identifier: MIT
"""The debug console: commands that travel, query and set, besides expressions.

In: a line of text. Out: an answer as text, and whether the session is elsewhere now.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.debugger.values import DEBUGGER, Values
from nctakt.lists.format.times import Time, read_time, time_stamp
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import NEVER_HELD, UNKNOWN_CONSOLE_COMMAND
from nctakt.session.engine import StepResult
from nctakt.session.session import Session

#: Names that a completion offers at most.
MAX_COMPLETIONS = 200

_HELP: dict[Language, str] = {
    "en": """\
tick                     the tick of the session
tick 1200, tick 1.2 s    go there
back 10 ms, back 3       go back by a time, or by ticks; back: by one
forward 10 ms            continue by a time or by ticks, past all breakpoints
last V.E.X               go back to the last change of a variable or expression
reaction                 go back to the last reaction of a realtime cycle
why 17:4                 why the branch in line 4 of cycle 17 has run, or has not; why 17, why
set V.E.X = 5            give a variable or a value of the HLI another value in the next tick
ack                      acknowledge what waits for the PLC
branches, branch 2       the branches of the tape; take one up again
stops                    how stops are written: until M100, until V.E.X > 5
until STOP               run to a stop
anything else            an expression: V.E.X, V.P.A, P5, V.RTA.ACS.ACT_POS.X > 20""",
    "de": """\
tick                     wo die Sitzung steht
tick 1200, tick 1.2 s    dorthin gehen
back 10 ms, back 3       um eine Zeit oder um Takte zurück; back: um einen
forward 10 ms            um eine Zeit oder um Takte weiter, an allen Haltepunkten vorbei
last V.E.X               zurück zur letzten Änderung einer Variablen oder eines Ausdrucks
reaction                 zurück zur letzten Reaktion eines Echtzeit-Zyklus
why 17:4                 warum der Zweig in Zeile 4 von Zyklus 17 lief oder nicht; why 17, why
set V.E.X = 5            einer Variablen oder einem Wert der HLI im nächsten Takt etwas zuweisen
ack                      quittieren, was auf die SPS wartet
branches, branch 2       die Zweige des Bands; einen davon wieder aufnehmen
stops                    wie Halte geschrieben werden: until M100, until V.E.X > 5
until STOP               bis zu einem Halt laufen
sonst                    ein Ausdruck: V.E.X, V.P.A, P5, V.RTA.ACS.ACT_POS.X > 20""",
}

_STOPS = """\
line 12 · line part.nc:12 · fires 6 · runs 6 · turns 6 · cycle 5 · changes V.E.X · written V.E.X
M100 · H7 · message · error · notice · V.E.X > 5
… if CONDITION · … 3 times"""

_WHY = re.compile(r"(?P<cycle>#?\d+)?(?::(?P<line>\d{1,9}))?")
_WHY_IN_CHANNEL = re.compile(r"(?P<cycle>\d+:#?\d+)?(?::(?P<line>\d{1,9}))?")
_SET = re.compile(r"(?P<name>[^=]*[^=\s<>!])\s*=\s*(?P<value>[^=].*)")
_WORD = re.compile(r"[\w.\[\]@#]*$")


@dataclass(frozen=True, slots=True)
class Answer:
    """The answer to a line; ``has_moved``: the session is elsewhere.

    ``until``: the text of a stop to which the debugger has to run.
    """

    text: str
    has_moved: bool = False
    until: str = ""


class Console:
    """The console of a session."""

    def __init__(self, session: Session, values: Values, language: Language) -> None:
        self._session = session
        self._values = values
        self._language: Language = language
        self._commands: dict[str, Callable[[str, int], Answer]] = {
            "help": lambda _rest, _channel: Answer(_HELP[language]),
            "stops": lambda _rest, _channel: Answer(_STOPS),
            "tick": self._tick,
            "back": self._back,
            "forward": self._forward,
            "last": self._last,
            "reaction": self._reaction,
            "why": self._why,
            "set": self._set,
            "ack": self._acknowledge,
            "branches": self._branches,
            "branch": self._branch,
            "until": self._until,
        }

    def run(self, line: str, channel: int) -> Answer:
        """Return the answer to a line; raises ``Failure`` for an unknown command."""
        word, _, rest = line.strip().partition(" ")
        command = self._commands.get(word.lower())
        if command is not None:
            return command(rest.strip(), channel)
        assigned = _SET.fullmatch(line.strip())
        if assigned is not None:
            return self._set(line, channel)
        if not line.strip():
            raise Failure(diagnostic(UNKNOWN_CONSOLE_COMMAND, text=line))
        return Answer(self._values.evaluate(line, channel))

    def is_command(self, line: str) -> bool:
        """Return whether a line begins with a command, or sets a value."""
        word = line.strip().partition(" ")[0].lower()
        return word in self._commands or _SET.fullmatch(line.strip()) is not None

    def travels(self, line: str) -> bool:
        """Return whether a line is a command that needs a session at rest."""
        word, _, rest = line.strip().partition(" ")
        if word.lower() in ("tick", "branch"):
            return bool(rest.strip())
        return word.lower() in ("back", "forward", "last", "reaction", "until", "set")

    def position(self) -> str:
        """Return where the session is: tick, time and branch."""
        session = self._session
        time_us = session.tick * session.description.cycle_time_us
        branch = f", branch {session.branch}" if len(session.branches) > 1 else ""
        if self._language == "de":
            branch = branch.replace("branch", "Zweig")
            return f"vor Takt {session.tick} = {time_stamp(time_us)}{branch}"
        return f"before tick {session.tick} = {time_stamp(time_us)}{branch}"

    # --- travelling -----------------------------------------------------------------------------

    def _ticks(self, text: str) -> int:
        """Return the ticks of a time; a whole number alone is one of ticks."""
        if text.isdecimal() and len(text) <= 12:
            return int(text)
        return read_time(text).ticks(self._session.description.cycle_time_us)

    def _moved(self, done: StepResult | None) -> Answer:
        if done is None:
            return Answer(diagnostic(NEVER_HELD).text(self._language))
        return Answer(self.position(), has_moved=True)

    def _tick(self, rest: str, _channel: int) -> Answer:
        if not rest:
            return Answer(self.position())
        tick = self._ticks(rest)
        reached = self._session.branches[self._session.branch]
        if tick <= reached:
            return self._moved(self._session.go_to(tick))
        self._session.go_to(reached)
        return self._moved(self._session.step(tick - reached))

    def _back(self, rest: str, _channel: int) -> Answer:
        return self._moved(self._session.back(self._ticks(rest or "1")))

    def _forward(self, rest: str, _channel: int) -> Answer:
        return self._moved(self._session.step(self._ticks(rest or "1")))

    def _last(self, rest: str, _channel: int) -> Answer:
        return self._moved(self._session.last_change(rest))

    def _until(self, rest: str, _channel: int) -> Answer:
        if not rest:
            raise Failure(diagnostic(UNKNOWN_CONSOLE_COMMAND, text="until"))
        return Answer("", until=rest)

    def _reaction(self, _rest: str, _channel: int) -> Answer:
        return self._moved(self._session.previous_reaction())

    def _branches(self, _rest: str, _channel: int) -> Answer:
        rows = []
        for number, reached in self._session.branches.items():
            mark = "*" if number == self._session.branch else " "
            rows.append(f"{mark} {number}: {Time(reached, is_in_ticks=True)}")
        return Answer("\n".join(rows))

    def _branch(self, rest: str, _channel: int) -> Answer:
        number = int(rest) if rest.isdecimal() and len(rest) < 9 else 0
        tick = min(self._session.tick, self._session.branches.get(number, 0))
        return self._moved(self._session.go_to(tick, number))

    # --- asking and setting ---------------------------------------------------------------------

    def _why(self, rest: str, _channel: int) -> Answer:
        several = self._session.description.channel_count > 1
        match = (_WHY_IN_CHANNEL if several else _WHY).fullmatch(rest)
        if match is None:
            raise Failure(diagnostic(UNKNOWN_CONSOLE_COMMAND, text=f"why {rest}"))
        line = None if match["line"] is None else int(match["line"])
        return Answer(self._session.why().select(match["cycle"], line).render(self._language))

    def _set(self, rest: str, channel: int) -> Answer:
        match = _SET.fullmatch(rest)
        if match is None:
            raise Failure(diagnostic(UNKNOWN_CONSOLE_COMMAND, text=f"set {rest}"))
        self._values.write(match["name"].strip(), match["value"], channel)
        return Answer(self._values.evaluate(match["name"].strip(), channel))

    def _acknowledge(self, _rest: str, _channel: int) -> Answer:
        waiting = self._session.waiting()
        for channel, entry in waiting:
            self._session.acknowledge(channel, entry, DEBUGGER)
        return Answer(", ".join(entry.name for _, entry in waiting) or "–")

    # --- completions ----------------------------------------------------------------------------

    def completions(self, text: str, column: int, channel: int) -> list[dict[str, Any]]:
        """Return the completions at a column, counted from 1."""
        before = text[: max(0, column - 1)]
        match = _WORD.search(before)
        begun = "" if match is None else match[0]
        names: Iterable[str] = (
            *(self._commands if before.strip() == begun else ()),
            *self._values.inventory.variables.get(channel, {}),
            *self._session.description.signals,
        )
        asked = begun.upper()
        fitting = [name for name in names if name.upper().startswith(asked)] if begun else []
        if not before.strip():
            fitting = list(self._commands)
        start = len(before) - len(begun) + 1
        return [
            {"label": name, "start": start, "length": len(begun), "type": _kind_of(name)}
            for name in list(dict.fromkeys(fitting))[:MAX_COMPLETIONS]
        ]


def _kind_of(name: str) -> str:
    return "variable" if "." in name else "keyword"
