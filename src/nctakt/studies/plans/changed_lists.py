# SPDX-License-Identifier: MIT
"""A machine with other values of some parameters, as if its lists had them.

In: a machine and values by ID and axis or channel. Out: another machine, loaded from the same
files, in which these entries are replaced or added while they are read. No file is written.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import NoReturn

from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.base.text import decode_text
from nctakt.files.access import FileAccess
from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.format.parameter import Parameter
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import UNKNOWN_PARAMETER_OF_STUDY

_AXIS_NAME = re.compile(r"^\s*kopf\.log_achs_name\s+(\S+)", re.MULTILINE)
_INDEX = re.compile(r"\[[^]]*\]")
_END = re.compile(r"^[ \t]*Ende?\b", re.MULTILINE | re.IGNORECASE)


def with_entry(text: str, name: str, value: str) -> str:
    """Return the text of a list in which an entry has a value."""
    entry = re.compile(rf"^[ \t]*{re.escape(name)}[ \t]+\S+", re.MULTILINE)
    line = f"{name} {value}"
    if entry.search(text):
        return entry.sub(line, text)
    if _END.search(text):
        return _END.sub(lambda found: f"{line}\n{found[0]}", text, count=1)
    return f"{text.rstrip()}\n{line}\n"


def changed_machine(machine: Machine, values: Mapping[tuple[str, str], float | str]) -> Machine:
    """Return a machine with these values.

    Raises ``Failure`` for an unknown parameter (901312), and with the lists' reports about a value
    that they refuse.
    """
    access = FileAccess()
    for path, text in changed_texts(machine, values).items():
        access.replace(path, text.encode("utf-8"))
    changed = load_machine(machine.lists[0][1], access=access)
    before = [(one.id, one.text()) for one in machine.diagnostics]
    found = [one for one in changed.diagnostics if (one.id, one.text()) not in before]
    if found:
        raise Failure(*found)
    return changed


def changed_texts(
    machine: Machine, values: Mapping[tuple[str, str], float | str]
) -> dict[Path, str]:
    """Return the texts of the lists of a machine that change with these values.

    Raises ``Failure`` for an unknown parameter (901312).
    """
    texts: dict[Path, str] = {}
    for (id_, owner), value in values.items():
        parameter, kind = _parameter(id_, owner)
        path = _list_of(machine, kind, id_, owner)
        name = _INDEX.sub("[0]", parameter.path)
        before = texts.get(path) or decode_text(FileAccess().read_bytes(path)).text
        texts[path] = with_entry(before, name, entry_text(value))
    return texts


def entry_text(value: float | str) -> str:
    """Return a value as a list has it."""
    if isinstance(value, str):
        return value
    return str(int(value)) if value == int(value) else repr(value)


def _parameter(id_: str, owner: str) -> tuple[Parameter, str]:
    """Return a parameter and the kind of its list."""
    for schema in SCHEMAS:
        for parameter in schema.parameters:
            if parameter.id == id_:
                return parameter, schema.kind
    ids = [parameter.id for schema in SCHEMAS for parameter in schema.parameters]
    near = nearest(id_, ids)
    refuse(id_, owner, unknown_parameter(near))


def _list_of(machine: Machine, kind: str, id_: str, owner: str) -> Path:
    """Return the list of an axis by its name, of a channel by its number, or the only one."""
    paths = [path for own, path in machine.lists if own == kind]
    if kind == "axis":
        named = {}
        for path in paths:
            match = _AXIS_NAME.search(decode_text(path.read_bytes()).text)
            if match is not None:
                named[match[1]] = path
        if owner in named:
            return named[owner]
        known = ", ".join(named)
        reason = Text(
            f"no axis of this name; known: {known}", f"keine Achse dieses Namens; bekannt: {known}"
        )
        refuse(id_, owner, reason)
    if kind == "channel" and owner:
        numbered = {str(channel.number): channel.startup.parameters for channel in machine.channels}
        found = numbered.get(owner)
        if found is None:
            known = ", ".join(numbered)
            reason = Text(
                f"no channel of this number; known: {known}",
                f"kein Kanal dieser Nummer; bekannt: {known}",
            )
            refuse(id_, owner, reason)
        end = found.path.replace("\\", "/").rpartition("../")[2]
        ends = [path for path in paths if path.as_posix().endswith(end)]
        if ends:
            return ends[0]
    if not paths:
        reason = Text(
            f"the machine has no list of the kind {kind}",
            f"die Maschine hat keine Liste der Art {kind}",
        )
        refuse(id_, owner, reason)
    if any(path.suffix.casefold() == ".xml" for path in paths):
        reason = Text("lists in XML cannot be varied", "Listen in XML lassen sich nicht variieren")
        refuse(id_, owner, reason)
    return paths[-1]


def unknown_parameter(near: str) -> Text:
    """Return the reason that there is no such parameter; ``near``: the nearest one, or nothing."""
    if not near:
        return Text("unknown parameter", "unbekannter Parameter")
    return Text(f"unknown parameter; nearest: {near}", f"unbekannter Parameter; ähnlich: {near}")


def refuse(id_: str, owner: str, reason: Text) -> NoReturn:
    """Raise ``Failure`` (901312) for a parameter that cannot be varied."""
    message = diagnostic(UNKNOWN_PARAMETER_OF_STUDY, parameter=id_, of=owner or "–", reason=reason)
    raise Failure(message)
