# SPDX-License-Identifier: MIT
"""Frames, scopes and variables of the protocol: contents of a stack and its variables.

In: a session at a tick. Out: frames of the interpolation, the decoder and realtime cycles, their
scopes, and the variables in these. Numbers of frames and variables hold until the run continues.
"""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from nctakt.base.diagnostics import Language, Span
from nctakt.base.failure import Failure
from nctakt.debugger.disassembly import Disassembly
from nctakt.debugger.names import Node, pieces_of, tree_of
from nctakt.debugger.plc_frames import BELOW, PLC_THREAD, SCOPE, PlcFrames
from nctakt.debugger.sources import Sources
from nctakt.debugger.values import Value, Values, elements_of, shown_value
from nctakt.hli.plc_entries import SpindleEntry
from nctakt.lists.format.times import time_stamp
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import NOT_RESTARTED, UNKNOWN_REFERENCE
from nctakt.plc.stepping.shown import PlcValue
from nctakt.session.decoders import DecoderState, DecoderVariable
from nctakt.session.engine import BranchState, CycleState
from nctakt.session.session import Session

#: The number of the first thread that is a realtime cycle; below it they are channels.
FIRST_CYCLE_THREAD = 1001

#: Values that the line of a structure shows.
_PREVIEWED = 3

Key = tuple[Any, ...]

_OPERAND = re.compile(r"\bVs?\.(?:E|CH|RTA|RTG|P|L|S|CYC)\.[A-Za-z_][\w.]*(?:\[\w+\][\w.]*)*")

_WORDS: dict[Language, dict[str, str]] = {
    "en": {
        "axes": "Axes", "channel": "Path and channel", "cycles": "Realtime cycles",
        "plc": "Waits for the PLC", "decoder": "decoder", "V.L": "V.L", "arguments": "Arguments",
        "parameters": "P parameters", "branches": "Branches", "true": "true", "false": "false",
        "never": "not evaluated yet", "ran": "has run", "runs": "runs", "since": "since",
        "channel n": "channel", "cycle n": "realtime cycle", "ahead": "decoder, ahead of the path",
    },
    "de": {
        "axes": "Achsen", "channel": "Bahn und Kanal", "cycles": "Echtzeit-Zyklen",
        "plc": "Wartet auf die SPS", "decoder": "Dekoder", "V.L": "V.L", "arguments": "Argumente",
        "parameters": "P-Parameter", "branches": "Zweige", "true": "wahr", "false": "falsch",
        "never": "noch nicht ausgewertet", "ran": "ist gelaufen", "runs": "Läufe", "since": "seit",
        "channel n": "Kanal", "cycle n": "Echtzeit-Zyklus", "ahead": "Dekoder, der Bahn voraus",
    },
}  # fmt: skip


class Scopes:
    """The view of a session at its tick; ``forget`` when it has moved on."""

    def __init__(
        self,
        session: Session,
        values: Values,
        sources: Sources,
        disassembly: Disassembly,
        language: Language,
    ) -> None:
        self._disassembly = disassembly
        self._session = session
        self._values = values
        self._sources = sources
        self._words = _WORDS[language]
        self.plc = PlcFrames(session, values, language)
        self._channels = range(1, session.description.channel_count + 1)
        self._cycle_threads: dict[str, int] = {}
        self._trees: dict[int, dict[str, Node]] = {}
        self._frames: list[Key] = []
        self._keys: list[Key] = []
        self._references: dict[Key, int] = {}

    def forget(self) -> None:
        """Forget frames and references."""
        self._disassembly.forget()
        self._frames.clear()
        self._keys.clear()
        self._references.clear()

    # --- threads --------------------------------------------------------------------------------

    def threads(self) -> list[dict[str, Any]]:
        """Return the threads: the channels, then the realtime cycles that have not ended."""
        words = self._words
        found = [
            {"id": number, "name": f"{words['channel n']} {number}"} for number in self._channels
        ]
        if self.plc.is_there:
            found.append(self.plc.thread)
        for cycle in self._session.cycles():
            if cycle.state == "ended":
                continue
            name = f"{words['cycle n']} {cycle.name} ({cycle.scope}, {cycle.state})"
            found.append({"id": self.thread_of_cycle(cycle.name), "name": name})
        return found

    def thread_of_cycle(self, name: str) -> int:
        """Return the thread of a realtime cycle, the same as long as the session lives."""
        return self._cycle_threads.setdefault(name, FIRST_CYCLE_THREAD + len(self._cycle_threads))

    def number_of_cycle(self, name: str) -> int:
        """Return the number of a realtime cycle among those that have a thread, from 1."""
        return self.thread_of_cycle(name) - FIRST_CYCLE_THREAD + 1

    def channel_of(self, thread: int) -> int:
        """Return the channel of a thread."""
        if thread in self._channels:
            return thread
        if self.is_plc(thread):
            return 1
        return _channel_of_cycle(self._cycle_of(thread).name)

    def is_cycle(self, thread: int) -> bool:
        """Return whether a thread is a realtime cycle."""
        return thread not in self._channels and not self.is_plc(thread)

    def is_plc(self, thread: int) -> bool:
        """Return whether a thread is the PLC in Structured Text."""
        return thread == PLC_THREAD and self.plc.is_there

    def _cycle_of(self, thread: int) -> CycleState:
        names = {number: name for name, number in self._cycle_threads.items()}
        for cycle in self._session.cycles():
            if cycle.name == names.get(thread):
                return cycle
        raise Failure(diagnostic(UNKNOWN_REFERENCE, what="thread", number=thread))

    # --- frames ---------------------------------------------------------------------------------

    def stack(self, thread: int) -> list[dict[str, Any]]:
        """Return the frames of a thread, the innermost first."""
        if self.is_plc(thread):
            return [
                self._frame(("plc", level), name, span)
                for level, (name, span) in enumerate(self.plc.frames())
            ]
        if thread not in self._channels:
            cycle = self._cycle_of(thread)
            ran = [branch.span for branch in cycle.branches if branch.has_run]
            name = f"{self._words['cycle n']} {cycle.name}"
            latest_branch = ran[-1] if ran else cycle.span
            frame = self._frame(("cycle", cycle.name), name, latest_branch)
            number = self.number_of_cycle(cycle.name)
            pointer = self._disassembly.pointer(number, latest_branch.line)
            frame["instructionPointerReference"] = pointer
            return [frame]
        latest = self._session.latest
        frames = []
        calls = latest.calls.get(thread, ())
        for level in range(len(calls) - 1, -1, -1):
            span = calls[level].span or latest.blocks.get(thread)
            frames.append(self._frame(("path", thread, level), calls[level].name, span))
        if not calls and thread == 1:
            frames.append(self._before_the_first_block())
        decoder = self._decoder(thread)
        if decoder is not None:
            frames.append(self._frame(("label", thread), self._words["ahead"], None, "label"))
            for level in range(len(decoder.frames) - 1, -1, -1):
                own = decoder.frames[level]
                key = ("decoder", thread, level)
                name = f"{own.name} [{self._words['decoder']}]"
                frames.append(self._frame(key, name, own.span, "subtle"))
        return frames

    def _before_the_first_block(self) -> dict[str, Any]:
        """Return the frame of a program that has not begun: the begin of its text."""
        name = next(iter(self._session.description.texts), "")
        return self._frame(("path", 1, 0), name, Span(name, 1, 1, 2))

    def depth(self, channel: int) -> int:
        """Return how many programs are open at the current block of a channel."""
        return len(self._session.latest.calls.get(channel, ()))

    def _frame(
        self, key: Key, name: str, span: Span | None, hint: str = "normal"
    ) -> dict[str, Any]:
        self._frames.append(key)
        frame: dict[str, Any] = {
            "id": len(self._frames),
            "name": name,
            "line": 0,
            "column": 0,
            "presentationHint": hint,
        }
        if key[0] != "path":
            frame["canRestart"] = False
        if span is not None:
            frame |= {"line": span.line, "column": 1, "source": self._sources.source(span.file)}
        return frame

    def _decoder(self, channel: int) -> DecoderState | None:
        for decoder in self._session.decoders():
            if decoder.channel == channel:
                return decoder
        return None

    def program_of_frame(self, frame: int) -> tuple[int, int]:
        """Return channel and level of the program of a frame; raises ``Failure`` for others."""
        if not 0 < frame <= len(self._frames):
            raise Failure(diagnostic(UNKNOWN_REFERENCE, what="frame", number=frame))
        kind, *where = self._frames[frame - 1]
        if kind != "path":
            raise Failure(diagnostic(NOT_RESTARTED))
        return int(where[0]), int(where[1])

    def channel_of_frame(self, frame: int) -> int:
        """Return the channel of a frame, 1 for none."""
        if not 0 < frame <= len(self._frames):
            return 1
        key = self._frames[frame - 1]
        if key[0] == "plc":
            return 1
        return _channel_of_cycle(key[1]) if key[0] == "cycle" else int(key[1])

    # --- scopes ---------------------------------------------------------------------------------

    def scopes(self, frame: int) -> list[dict[str, Any]]:
        """Return the scopes of a frame."""
        if not 0 < frame <= len(self._frames):
            raise Failure(diagnostic(UNKNOWN_REFERENCE, what="frame", number=frame))
        kind, owner, *level = self._frames[frame - 1]
        words = self._words
        if kind == "cycle":
            channel = _channel_of_cycle(owner)
            first = self._scope(words["branches"], ("cycle", owner))
            return [first, *self._of_channel(channel, ("V.E", "V.RTA", "V.RTG", "axes"))]
        if kind == "decoder":
            return [
                self._scope(title, ("decoder", owner, level[0], part))
                for part, title in (
                    ("L", "V.L"), ("P", "V.P"), ("S", "V.S"), ("CYC", "V.CYC"),
                    ("arguments", words["arguments"]), ("parameters", words["parameters"]),
                )
            ]  # fmt: skip
        if kind == "label":
            return []
        if kind == "plc":
            return [self._scope(name, (SCOPE, owner, name)) for name in self.plc.scopes(owner)]
        roots = ("axes", "channel", "V.E", "V.CH", "V.RTA", "V.RTG", "HLI")
        return [
            *self._of_channel(owner, roots),
            self._scope(words["cycles"], ("cycles", owner)),
            self._scope(words["plc"], ("plc", owner)),
            *(
                self._scope(f"V.{part} [{words['decoder']}]", ("decoder", owner, -1, part))
                for part in ("P", "L", "S")
            ),
        ]

    def _of_channel(self, channel: int, roots: Sequence[str]) -> list[dict[str, Any]]:
        trees = self._tree(channel)
        return [
            self._scope(self._words.get(root, root), ("tree", channel, root, ()))
            for root in roots
            if trees[root].children
        ]

    def _scope(self, name: str, key: Key) -> dict[str, Any]:
        is_dear = key[0] == "tree" and key[2] in ("V.RTA", "V.RTG", "V.CH")
        return {"name": name, "variablesReference": self._reference(key), "expensive": is_dear}

    def _reference(self, key: Key) -> int:
        if key not in self._references:
            self._keys.append(key)
            self._references[key] = len(self._keys)
        return self._references[key]

    def _tree(self, channel: int) -> dict[str, Node]:
        """Return the names of a channel by scope."""
        if channel not in self._trees:
            signals = self._session.description.signals
            prefix = "" if channel == 1 else f"CH{channel}."
            own = [name.removeprefix(prefix) for name in signals if name.startswith(prefix)]
            own = [name for name in own if not re.match(r"CH\d+\.", name)]
            axes = {name.partition(".")[0] for name in own if name.endswith(".ACS.ACT_POS")}
            values = [*self._values.inventory.variables.get(channel, ())]
            values += [name for name in own if name.startswith("HLI.")]
            others = [name for name in own if not name.startswith(("V.", "HLI."))]
            of_axes = [name for name in others if name.partition(".")[0] in axes]
            whole = tree_of(values)
            names = whole.children.get("V", Node("V"))
            self._trees[channel] = {
                "axes": tree_of(of_axes),
                "channel": tree_of(name for name in others if name.partition(".")[0] not in axes),
                "HLI": whole.children.get("HLI", Node("HLI")),
                **{
                    f"V.{family}": names.children.get(family, Node(family))
                    for family in ("E", "CH", "RTA", "RTG")
                },
            }
        return self._trees[channel]

    # --- variables ------------------------------------------------------------------------------

    def variables(self, reference: int, first: int, count: int) -> list[dict[str, Any]]:
        """Return the variables of a scope or of another variable, from ``first`` on."""
        kind, *rest = self._key(reference)
        if kind in (SCOPE, BELOW):
            key = (kind, *rest)
            return [self.of_plc(one, rest[0]) for one in self.plc.variables(key, first, count)]
        if kind == "tree":
            return self._of_tree(rest[0], rest[1], rest[2], first, count)
        if kind == "cycles":
            found = self._cycles(*rest)
        elif kind == "cycle":
            found = self._branches(*rest)
        elif kind == "branch":
            found = self._operands(*rest)
        elif kind == "members":
            found = self._members(*rest)
        elif kind == "plc":
            found = self._waiting(*rest)
        else:
            found = self._of_decoder(*rest)
        return found[first:][: count or None]

    def level_of(self, frame: int) -> int | None:
        """Return the level of the PLC's call that a frame shows, ``None`` for other frames."""
        if not 0 < frame <= len(self._frames) or self._frames[frame - 1][0] != "plc":
            return None
        return int(self._frames[frame - 1][1])

    def of_plc(self, found: PlcValue, level: int | None) -> dict[str, Any]:
        """Return a variable of the PLC."""
        shown = _variable(found.name, found.text + self.plc.note_of(found), found.type)
        shown["evaluateName"] = found.path
        if found.count:
            shown["variablesReference"] = self._reference((BELOW, level, found.path))
            shown["indexedVariables" if found.indexed else "namedVariables"] = found.count
        return shown

    def plc_variable(self, reference: int, name: str) -> PlcValue | None:
        """Return the variable of the PLC that a reference has by a name; ``None`` for others."""
        key = self._key(reference)
        if key[0] not in (SCOPE, BELOW):
            return None
        for one in self.plc.variables(key, 0, 0):
            if one.name == name:
                return one
        return self.plc.value(f"{key[2]}{name}" if key[0] == BELOW else name, key[1])

    def full_name(self, reference: int, name: str) -> tuple[str, int]:
        """Return the whole name of a variable in a scope, and its channel."""
        key = self._key(reference)
        if key[0] == "tree":
            node = self._tree(key[1])[key[2]].find((*key[3], name))
            if node is not None and node.full:
                return node.full, key[1]
        if key[0] in ("decoder", "elements", "members"):
            return name, key[1]
        if key[0] == "branch":
            return name, _channel_of_cycle(key[1])
        return name, 1

    def _key(self, reference: int) -> Key:
        if not 0 < reference <= len(self._keys):
            raise Failure(diagnostic(UNKNOWN_REFERENCE, what="variable", number=reference))
        return self._keys[reference - 1]

    def _of_tree(
        self, channel: int, root: str, path: tuple[str, ...], first: int, count: int
    ) -> list[dict[str, Any]]:
        node = self._tree(channel)[root].find(path)
        children = list(node.children.values()) if node is not None else []
        children = children[first:][: count or None]
        leaves = [leaf for child in children for leaf in _leaves(child)]
        values = dict(zip(leaves, self._values.read(leaves, channel), strict=True))
        types = self._values.inventory.variables.get(channel, {})
        found = []
        for child in children:
            if child.full:
                text = shown_value(values[child.full]) + self._values.note_of(child.full, channel)
                shown = _variable(child.piece, text, types.get(child.full, ""))
                shown["evaluateName"] = child.full
            else:
                below = (*path, child.piece)
                key = ("tree", channel, root, below)
                shown = self._unfolding(child, _preview(child, values), key)
                shown["evaluateName"] = _name_of(root, below)
            found.append(shown)
        return found

    def structure(self, text: str, channel: int) -> dict[str, Any] | None:
        """Return a name for several values, as a variable; ``None`` for any other."""
        pieces = pieces_of(text.strip())
        for root, path in _roots(pieces):
            node = self._tree(channel)[root].find(path)
            if node is not None and node.children and not node.full:
                leaves = _leaves(node)
                values = dict(zip(leaves, self._values.read(leaves, channel), strict=True))
                return self._unfolding(node, _preview(node, values), ("tree", channel, root, path))
        return self._decoded(pieces, channel)

    def _unfolding(self, node: Node, text: str, key: Key) -> dict[str, Any]:
        """Return a variable with its children to be asked for."""
        shown = _variable(node.piece, text, "")
        shown["variablesReference"] = self._reference(key)
        shown["indexedVariables" if node.is_array else "namedVariables"] = len(node.children)
        return shown

    def _decoded(self, pieces: Sequence[str], channel: int) -> dict[str, Any] | None:
        """Return a family of the decoder's variables, or an array of them."""
        family = pieces[1].upper() if len(pieces) > 1 and pieces[0].upper() == "V" else ""
        decoder = self._decoder(channel)
        if family not in ("P", "L", "S", "CYC") or decoder is None or not decoder.frames:
            return None
        if len(pieces) == 2:
            found = self._of_decoder(channel, -1, family)
            text = ", ".join(f"{one['name']} {one['value']}" for one in found[:_PREVIEWED])
            shown = _variable(f"V.{family}", text + (", …" if len(found) > _PREVIEWED else ""), "")
            shown["variablesReference"] = self._reference(("decoder", channel, -1, family))
            return shown
        asked = "".join(one if one.startswith("[") else f".{one}" for one in pieces)[1:].upper()
        for level in range(len(decoder.frames) - 1, -1, -1):
            for variable in _group(decoder, level, family):
                if variable.dimensions and variable.name.upper() == asked:
                    return self._array(variable, ("decoder", channel, level, variable.name))
                if variable.name.upper().startswith(f"{asked}."):
                    own = variable.name[: len(asked)]
                    return self._structure(decoder, channel, level, own)
        return None

    def _array(self, variable: DecoderVariable, key: Key) -> dict[str, Any]:
        """Return an array of the decoder with its first values."""
        shape = "".join(f"[{count}]" for count in variable.dimensions)
        values = [shown_value(value) for value in variable.values[:_PREVIEWED]]
        more = ", …" if variable.count > len(values) else ""
        shown = _variable(variable.name, f"{shape} {', '.join(values)}{more}", variable.type)
        shown["variablesReference"] = self._reference(key)
        shown["indexedVariables"] = len(variable.values)
        return shown

    def _cycles(self, channel: int) -> list[dict[str, Any]]:
        found = []
        for cycle in self._session.cycles():
            if _channel_of_cycle(cycle.name) == channel:
                text = f"{cycle.scope}, {cycle.state}, {cycle.runs} {self._words['runs']}"
                shown = _variable(cycle.name, text, "")
                shown["variablesReference"] = self._reference(("cycle", cycle.name))
                found.append(shown)
        return found

    def _branches(self, name: str) -> list[dict[str, Any]]:
        found = []
        for cycle in self._session.cycles():
            for branch in cycle.branches if cycle.name == name else ():
                line = self._sources.line(branch.span.file, branch.span.line)
                shown = _variable(f"{branch.span.line}: {line}", self._state(branch), "")
                if _OPERAND.search(line):
                    shown["variablesReference"] = self._reference(("branch", name, line))
                found.append(shown)
        return found

    def _state(self, branch: BranchState) -> str:
        words = self._words
        truth = {True: words["true"], False: words["false"], None: words["never"]}[branch.truth]
        ran = f", {words['ran']}" if branch.has_run else ""
        return f"{truth}{ran}, {branch.count} {words['runs']}"

    def _operands(self, cycle: str, line: str) -> list[dict[str, Any]]:
        channel = _channel_of_cycle(cycle)
        found = []
        for name in dict.fromkeys(_OPERAND.findall(line)):
            with contextlib.suppress(Failure):
                shown = _variable(name, self._values.evaluate(name, channel), "")
                shown["evaluateName"] = name
                found.append(shown)
        return found

    def _waiting(self, channel: int) -> list[dict[str, Any]]:
        found = []
        for number, entry in self._session.waiting():
            if number != channel:
                continue
            what = (
                f"M{entry.function}" if isinstance(entry, SpindleEntry) else entry.synchronisation
            )
            text = f"{what} {self._words['since']} {time_stamp(entry.time_us)}"
            found.append(_variable(entry.name, text, ""))
        return found

    def _of_decoder(self, channel: int, level: int, part: str) -> list[dict[str, Any]]:
        decoder = self._decoder(channel)
        if decoder is None or not decoder.frames or not -1 <= level < len(decoder.frames):
            return []
        if part not in ("P", "S", "CYC", "L", "arguments", "parameters"):
            return self._elements(decoder, level, part)
        frame = decoder.frames[level]
        if part == "arguments":
            return [_named(f"@P{number}", value) for number, value in frame.arguments.items()]
        if part == "parameters":
            return [_named(f"P{number}", value) for number, value in decoder.parameters.items()]
        return self._members(channel, level, f"V.{part}")

    def _members(self, channel: int, level: int, name: str) -> list[dict[str, Any]]:
        """Return the variables of the decoder below a name: values, arrays, structures."""
        decoder = self._decoder(channel)
        if decoder is None or not -1 <= level < len(decoder.frames):
            return []
        found: dict[str, dict[str, Any]] = {}
        for variable in _group(decoder, level, name.split(".")[1]):
            if not variable.name.startswith(f"{name}."):
                continue
            piece, dot, _ = variable.name[len(name) + 1 :].partition(".")
            own = f"{name}.{piece}"
            if dot:
                found.setdefault(own, self._structure(decoder, channel, level, own))
            elif variable.dimensions:
                found[own] = self._array(variable, ("decoder", channel, level, variable.name))
            else:
                found[own] = _named(variable.name, variable.values[0], variable.type)
        return list(found.values())

    def _structure(
        self, decoder: DecoderState, channel: int, level: int, name: str
    ) -> dict[str, Any]:
        """Return a structure of the decoder's variables with its first values."""
        inside = [
            one
            for one in _group(decoder, level, name.split(".")[1])
            if one.name.startswith(f"{name}.")
        ]
        texts = [
            f"{one.name[len(name) + 1 :]} {shown_value(one.values[0]) if one.values else '–'}"
            for one in inside[:_PREVIEWED]
        ]
        more = ", …" if len(inside) > _PREVIEWED else ""
        shown = _variable(name, ", ".join(texts) + more, "")
        shown["variablesReference"] = self._reference(("members", channel, level, name))
        shown["evaluateName"] = name
        return shown

    def _elements(self, decoder: DecoderState, level: int, name: str) -> list[dict[str, Any]]:
        """Return the elements of an array of the decoder; how many are not shown is reported."""
        family = name.split(".")[1]
        for variable in _group(decoder, level, family):
            if variable.name == name:
                found = [_named(f"{name}{index}", value) for index, value in elements_of(variable)]
                left_out = variable.count - len(found)
                return [*found, _variable("…", f"+ {left_out}", "")] if left_out else found
        return []


def _group(decoder: DecoderState, level: int, family: str) -> Sequence[DecoderVariable]:
    if family == "L":
        return decoder.frames[level].variables
    return {"P": decoder.program, "S": decoder.kept}.get(family, decoder.cycle)


def _roots(pieces: Sequence[str]) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield the scopes in which a name may be, with its path there."""
    if len(pieces) > 1 and pieces[0] == "V" and pieces[1] in ("E", "CH", "RTA", "RTG"):
        yield f"V.{pieces[1]}", tuple(pieces[2:])
    elif pieces and pieces[0] == "HLI":
        yield "HLI", tuple(pieces[1:])
    elif pieces:
        yield "axes", tuple(pieces)
        yield "channel", tuple(pieces)


def _name_of(root: str, path: Sequence[str]) -> str:
    """Return the name by which a node of a scope can be asked for."""
    first = () if root in ("axes", "channel") else (root,)
    name = "".join(one if one.startswith("[") else f".{one}" for one in (*first, *path))
    return name.removeprefix(".")


def _leaves(node: Node) -> list[str]:
    """Return the full names of the first values below a node, or its own."""
    if node.full:
        return [node.full]
    found: list[str] = []
    for child in node.children.values():
        if len(found) > _PREVIEWED:
            break
        found += _leaves(child)
    return found


def _preview(node: Node, values: Mapping[str, Value]) -> str:
    """Return the first values below a node, each with its name from there on."""
    leaves = _leaves(node)
    shown = [shown_value(values[leaf]) for leaf in leaves[:_PREVIEWED]]
    more = ", …" if len(leaves) > _PREVIEWED else ""
    count = f"[{len(node.children)}] " if node.is_array else ""
    if not node.is_array or any(child.children for child in node.children.values()):
        names = [_below(node, leaf) for leaf in leaves]
        shown = [f"{name} {text}" for name, text in zip(names, shown, strict=False)]
    return count + ", ".join(shown) + more


def _below(node: Node, leaf: str) -> str:
    """Return the part of a leaf's name that comes after the piece of a node above it."""
    pieces = pieces_of(leaf)
    rest = pieces[pieces.index(node.piece) + 1 :] if node.piece in pieces else pieces
    return "".join(one if one.startswith("[") else f".{one}" for one in rest).removeprefix(".")


def _channel_of_cycle(name: str) -> int:
    number, colon, _ = name.partition(":")
    return int(number) if colon else 1


def _named(name: str, value: Value, type_: str = "") -> dict[str, Any]:
    return {**_variable(name, shown_value(value), type_), "evaluateName": name}


def _variable(name: str, value: str, type_: str) -> dict[str, Any]:
    variable: dict[str, Any] = {"name": name, "value": value, "variablesReference": 0}
    if type_:
        variable["type"] = type_
    return variable
