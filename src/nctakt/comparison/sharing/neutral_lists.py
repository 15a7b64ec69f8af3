# SPDX-License-Identifier: MIT
"""The lists of a machine without private parts: entries that have an effect, neutral names.

In: a loaded machine, the names that are given. Out: ASCII lists by name, the start-up list first.
Comments, unknown entries and entries without effect are left out; names of axes, spindles and
functions stay, since programs are written with them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from nctakt.comparison.sharing.neutral_names import NeutralNames
from nctakt.files.access import FileAccess
from nctakt.lists.all_parameters import SCHEMA_BY_KIND
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.format.parameter import Effect, ValueType
from nctakt.lists.machine.files import ListSearch
from nctakt.lists.machine.machine import Machine
from nctakt.lists.writing.list_items import Comment, Item, read_items
from nctakt.lists.writing.list_writer import ascii_text

#: The name of the start-up list, by which a folder is a machine.
_STARTUP = "hochlauf.lis"
#: Texts that stay: names of axes, of spindles, of the controller's functions.
_KEPT = frozenset(
    (
        "kopf.log_achs_name",
        "gruppe[].achse[].bezeichnung",
        "spindel[].bezeichnung",
        "main_spindle_name",
        "default_ax_name_of_spindle",
        "m_default_outp_ax_name[]",
        "h_default_outp_ax_name[]",
        "thread[].function[].name",
    )
)
#: Prefixes of the patterns of the user's names and types.
_OWN = ("var[", "vch[", "struct[", "coordinate_system.", "thread[")
_PROGRAM = "_prog_file"


def neutral_lists(machine: Machine, names: NeutralNames, access: FileAccess) -> dict[str, str]:
    """Return the lists by their neutral names; raises ``Failure`` if one cannot be read."""
    startup = machine.lists[0][1]
    search = ListSearch(startup, access, startup.parent)
    files: dict[Path, str] = {}
    for kind, path in machine.lists:
        number = len(files) + 1
        files.setdefault(path.resolve(), f"{kind}{number}.lis" if files else _STARTUP)
    found: dict[str, str] = {}
    for kind, path in machine.lists:
        name = files[path.resolve()]
        if name not in found:
            items = read_items(access.read_bytes(path), SCHEMA_BY_KIND[kind])
            listed = files if kind == "startup" else {}
            kept = _neutral(items, listed, search, names)
            lines = ascii_text(kept, "en").splitlines()
            found[name] = "".join(f"{line.partition('(')[0].rstrip()}\n" for line in lines)
    return found


def _neutral(
    items: list[Comment | Item],
    files: Mapping[Path, str],
    search: ListSearch,
    names: NeutralNames,
) -> Iterator[Item]:
    for item in items:
        parameter = item.parameter if isinstance(item, Item) else None
        if parameter is None or parameter.effect is not Effect.USED:
            continue
        assert isinstance(item, Item)
        value: str | None = item.value
        if parameter.type is ValueType.STRING and item.value:
            file = search.find(item.value) if files else None
            value = None if file is None else files.get(file.resolve())
            if value is None:
                value = _text(parameter.pattern, item.value, names)
        if value is not None:
            yield replace(item, value=value, comment="")


def _text(pattern: str, value: str, names: NeutralNames) -> str | None:
    """Return the neutral text of a parameter; ``None`` if it is left out."""
    if pattern in _KEPT or value.upper() in SCALARS:
        return value
    if pattern.startswith(_OWN):
        return names.name(value)
    return names.file(value) if _PROGRAM in pattern else None
