# SPDX-License-Identifier: MIT
"""A folder with 300 entries of all kinds of lists that differ from their defaults.

Each entry has a comment that says what becomes of it, from the published facts: it takes effect, it
would or may change a run and is reported, or no run depends on it.
"""

from __future__ import annotations

import re
from pathlib import Path

from nctakt.checking.check import check_files
from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.format.parameter import shown
from nctakt.lists.machine.list_kinds import kind_of
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime.assembly import AssembledMachine

FOLDER = Path(__file__).parent.parent / "machines" / "workshop"
COUNT = 300

#: The comment of an entry -> the findings about it.
FINDINGS = {
    "used": (),
    "would change a run": (900970,),
    "may change a run": (900971,),
    "no effect": (900026,),
}
_ENTRY = re.compile(r"(\S+)\s+(\S+) \( (.*) \)")

#: A place in the lists: the file and the line.
Place = tuple[str, int]


def entries() -> dict[Place, tuple[str, str, str]]:
    """Name, value and comment of each marked entry."""
    found = {}
    for file in sorted(FOLDER.iterdir()):
        for number, line in enumerate(file.read_text("utf-8").splitlines(), start=1):
            entry = _ENTRY.fullmatch(line)
            if entry is not None:
                found[file.name, number] = (entry[1], entry[2], entry[3])
    return found


def findings() -> dict[Place, tuple[int, ...]]:
    """The numbers of the findings at each place, of the folder as a whole."""
    found: dict[Place, tuple[int, ...]] = {}
    checked = check_files([FOLDER], AssembledMachine(load_machine(None)), detail="all")
    for one in checked.findings:
        span = one.diagnostic.span
        place = (Path(one.file).name, 0 if span is None else span.line)
        found[place] = (*found.get(place, ()), one.diagnostic.id)
    return found


def test_what_becomes_of_each_of_300_entries() -> None:
    """Each is in effect or reported with its line, and nothing else is found."""
    marked = entries()
    assert len(marked) >= COUNT
    expected = {place: FINDINGS[comment] for place, (_, _, comment) in marked.items()}
    expected["ddl.lis", 1] = (900583,)  # no start-up list names it
    assert findings() == {place: numbers for place, numbers in expected.items() if numbers}


def test_entries_of_all_kinds_differ_from_their_defaults() -> None:
    """What equals its default would prove nothing."""
    kinds = set()
    for (file, _), (name, value, _) in entries().items():
        schema = kind_of(file, (FOLDER / file).read_bytes())
        assert schema is not None, file
        kinds.add(schema.kind)
        found = schema.find(re.sub(r"\[\d+\]", "[]", name))
        assert found is not None, name
        assert value.strip('"') != shown(found[0].default), name
    assert kinds == {schema.kind for schema in SCHEMAS}


def test_the_folder_is_summed_up() -> None:
    """Without ``--effects`` one warning and one note for a list, and a program runs."""
    controller = Controller(FOLDER)
    numbers = [one.id for one in load_machine(FOLDER).diagnostics]
    assert set(numbers) == {900028, 900029}
    assert numbers.count(900028) == 3  # channel, axis, tools
    assert controller.run(NcText("p.nc", "G01 X1 F1\nM30\n")).state == "ended"
