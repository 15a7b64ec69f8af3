# SPDX-License-Identifier: MIT
"""Machine folders with mistakes that chance has made.

In: the lists of a machine, a ``Random``. Out: the lists with one to six changes: entries that are
missing, doubled, swapped, have other values, indices or names, lists that are missing or replace
each other. The same seed gives the same folder.
"""

from __future__ import annotations

import re
from pathlib import Path
from random import Random

from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.machine.files import STARTUP_NAMES

VALUES = (
    *("0", "1", "2", "3", "-1", "7", "20", "255", "1000", "65536", "99999999999", "-2147483649"),
    *("0.0", "0.5", "-0.001", "1e-9", "1e9", "1e308", ".", "0x10", "TRUE", "FALSE", "X", "Y", "S"),
    *('"', "A B", "MOS", "MNS_SNS", "MVS_SVS", "UNS08", "REAL64", "STRING[5]", "[3]", "", "#"),
    *("./sda_mds1.lis", "./achs_mds1.lis", "./hochlauf.lis", "..", "./nowhere.lis", "/dev/null"),
)
_INDEX = re.compile(r"\[(\d+)\]")
_NAMES = [parameter.pattern for schema in SCHEMAS for parameter in schema.parameters]


def mutated(lists: dict[str, str], chance: Random) -> dict[str, str]:
    """Return the lists with some changes."""
    changed = dict(lists)
    for _ in range(chance.randint(1, 6)):
        _change(changed, chance)
    return changed


def _change(lists: dict[str, str], chance: Random) -> None:
    name = chance.choice(sorted(lists))
    lines = lists[name].split("\n")
    kind = chance.randrange(12)
    place = chance.randrange(len(lines))
    if kind < 2:
        del lines[place]
    elif kind == 2:
        lines.insert(chance.randrange(len(lines)), lines[place])
    elif kind == 3:
        other = chance.choice(sorted(lists))
        lines.insert(place, chance.choice(lists[other].split("\n")))
    elif kind < 7:
        lines[place] = _with_value(lines[place], chance)
    elif kind < 9:
        lines[place] = _with_index(lines[place], chance)
    elif kind == 9:
        pattern = chance.choice(_NAMES).replace("[]", f"[{chance.randrange(4)}]")
        lines.insert(place, f"{pattern} {chance.choice(VALUES)}")
    elif kind == 10:
        cut = chance.randrange(len(lines[place]) + 1)
        lines[place] = lines[place][:cut] + chance.choice(("", "#", "\0", "é", " ", "[", "1"))
    elif chance.random() < 0.5 and name not in STARTUP_NAMES:
        del lists[name]
        return
    else:
        lists[name] = lists[chance.choice(sorted(lists))]
        return
    lists[name] = "\n".join(lines)


def _with_value(line: str, chance: Random) -> str:
    words = line.split(None, 1)
    return f"{words[0]} {chance.choice(VALUES)}" if words else line


def _with_index(line: str, chance: Random) -> str:
    number = chance.choice(("0", "1", "2", "5", "19", "99", "9999999"))
    found = list(_INDEX.finditer(line))
    if not found:
        return line
    one = chance.choice(found)
    return f"{line[: one.start(1)]}{number}{line[one.end(1) :]}"


def write(lists: dict[str, str], folder: Path) -> None:
    """Write the lists into a new folder."""
    folder.mkdir()
    for name, text in lists.items():
        (folder / name).write_text(text, "utf-8", newline="\n")
