# SPDX-License-Identifier: MIT
"""Articles about the variables declared by a machine's lists: V.E and V.CH.

In: a machine, a name as in a program. Out: the articles of the variables of this name, or
diagnostics with the nearest one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.base.misspelling import nearest
from nctakt.lists.machine.external.variables import AccessRights, Node, Variable, VariableScope
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import (
    MISSPELLED_MACHINE_VARIABLE,
    NAMES_OF_DEMO_MACHINE,
    UNKNOWN_MACHINE_VARIABLE,
)
from nctakt.reference.article import Article, Fact, fact

_INDEX = re.compile(r"\[[^\]]*\]")

_RIGHTS = {
    AccessRights.READ_WRITE: Text("read and write", "lesen und schreiben"),
    AccessRights.READ_ONLY: Text("read", "lesen"),
    AccessRights.WRITE_ONLY: Text("write", "schreiben"),
}
_SYNCHRONOUS = {
    True: Text(
        "TRUE: realtime cycles read and write it in each tick",
        "TRUE: Echtzeit-Zyklen lesen und schreiben sie in jedem Takt",
    ),
    False: Text(
        "FALSE: realtime cycles see its value at decoding",
        "FALSE: Echtzeit-Zyklen sehen ihren Wert beim Dekodieren",
    ),
}


class MachineVariables:
    """The variables of a machine, loaded or in ``folder``; ``None``: of the demo machine.

    Raises ``Failure`` if no machine results.
    """

    def __init__(self, folder: str | Machine | None) -> None:
        self._machine = folder if isinstance(folder, Machine) else load_machine(folder)

    def find(self, word: str) -> list[Article]:
        """Return the articles of all variables of this name, those of each channel apart.

        Of a family, ``V.E`` or ``V.CH``, those of all its variables.
        """
        folded = _plain(word).casefold()
        return [
            _article(self._machine, name, variable, node, channel)
            for name, variable, node, channel in _declared(self._machine)
            if folded in (name.casefold(), variable.space.value.casefold())
        ]

    def unknown(self, word: str) -> tuple[Diagnostic, ...]:
        """Return the diagnostic of a name that the machine does not declare."""
        near = nearest(_plain(word), sorted({name for name, _, _, _ in _declared(self._machine)}))
        error = diagnostic(UNKNOWN_MACHINE_VARIABLE, name=word, plc=Text("", ""))
        if near:
            error = diagnostic(MISSPELLED_MACHINE_VARIABLE, name=word, nearest=near)
        return (error, diagnostic(NAMES_OF_DEMO_MACHINE)) if self._machine.is_demo else (error,)


def _plain(word: str) -> str:
    """Return the name with ``V.`` and without indices: ``Vs.E.A[3].B`` -> ``V.E.A.B``."""
    name = _INDEX.sub("", word)
    return f"V.{name[3:]}" if name[:3].casefold() == "vs." else name


def _declared(machine: Machine) -> Iterator[tuple[str, Variable, Node, int]]:
    """Yield each variable and member: name, variable, node, channel (0: all channels)."""
    for variable in machine.global_variables:
        for name, node in _nodes(f"{variable.space.value}.{variable.name}", variable.node):
            yield name, variable, node, 0
    for channel in machine.channels:
        for variable in (*channel.external_variables, *channel.channel_variables):
            if variable.scope is VariableScope.GLOBAL and variable in machine.global_variables:
                continue
            for name, node in _nodes(f"{variable.space.value}.{variable.name}", variable.node):
                yield name, variable, node, channel.number


def _nodes(name: str, node: Node) -> Iterator[tuple[str, Node]]:
    yield name, node
    for member in node.members:
        yield from _nodes(f"{name}.{member.name}", member)


def _article(machine: Machine, name: str, variable: Variable, node: Node, channel: int) -> Article:
    kind = Text(f"variable of the machine {machine.name}", f"Variable der Maschine {machine.name}")
    meaning = Text("all channels share it", "alle Kanäle teilen sie")
    if channel:
        meaning = Text(f"a variable of channel {channel}", f"eine Variable von Kanal {channel}")
    return Article(name, kind, meaning, tuple(_facts(variable, node)))


def _facts(variable: Variable, node: Node) -> Iterator[Fact]:
    yield fact("Type", "Typ", node.type)
    if node.members:
        yield fact("Members", "Elemente", ", ".join(member.name for member in node.members))
    if node.array_elements:
        count = node.array_elements
        yield fact("Elements", "Feldlänge", Text(f"{count}, from index 0", f"{count}, ab Index 0"))
    if not node.members:
        yield fact("Synchronous", "Synchron", _SYNCHRONOUS[node.synchronous])
        yield fact("Programs may", "Programme dürfen", _RIGHTS[node.rights])
    seen = Text("sees it", "sieht sie")
    if variable.space.value == "V.CH":
        seen = Text("does not see it", "sieht sie nicht")
    yield fact("PLC", "SPS", seen)
