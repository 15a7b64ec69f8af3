# SPDX-License-Identifier: MIT
"""A single list -> its kind, and its diagnostics.

In: the bytes of one list. Out: the schema with most of its entries, diagnostics. Dependences on
other lists (values of a defaults list, axes that the start-up list does not have) are not checked
here but with the machine's folder (``machine.py``).
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.lists.all_parameters import FAMILIES, SCHEMA_BY_KIND, SCHEMAS
from nctakt.lists.declared.schemas import RTCONF, STARTUP, VARIABLES
from nctakt.lists.declared.startup import ListReference, StartupConfiguration
from nctakt.lists.format.list_check import load_list
from nctakt.lists.format.reader import Entry, ListDialect, read_list
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.without_effect import Detail
from nctakt.lists.format.xml_reader import is_xml, root_and_families
from nctakt.lists.machine.external.variables import variables_configuration
from nctakt.lists.machine.schedules.scheduling import load_rtconf
from nctakt.lists.machine.schedules.scheduling_profile import STANDARD_OPTIONS, RtconfOptions
from nctakt.messages import Collector

#: Usual file names of each kind, for lists whose entries do not decide.
_NAMES = {
    "startup": re.compile("hochlauf|startup"),
    "channel": re.compile("sda_mds|default_sda|kanal|channel"),
    "axis": re.compile("achs_mds|default_achs|ax_mds|axis|achse"),
    "variables": re.compile("ext_var|ve_var|v_ch|extv"),
    "tools": re.compile("werkz|tool"),
    "zero_offsets": re.compile("nullp|zero"),
    "clamp_offsets": re.compile("pzv|platz|clamp"),
    "rtconf": re.compile("rtconf"),
    "axis_compensation": re.compile("achs_kw|achskw|ax_comp"),
    "manual_mode": re.compile("hand_mds|handmds|manual"),
    "volumetric_compensation": re.compile("vol_?comp"),
    "scene": re.compile("scene"),
    "hardware": re.compile("hw_conf|hardware"),
    "list_description": re.compile("ddl"),
}


#: The outermost element of a list in XML -> its kind.
_XML_ROOTS = {
    "RTConfiguration": "rtconf",
    "StartUp": "startup",
    "AX_MDS": "axis",
    "Default_AX_MDS": "axis",
    "SDA_MDS": "channel",
    "Default_SDA_MDS": "channel",
    "ExtVar": "variables",
    "ToolData": "tools",
    "ZeroOffset": "zero_offsets",
    "ClampPosOffset": "clamp_offsets",
    "ManualMode": "manual_mode",
    "AX_COMP": "axis_compensation",
    "VolComp": "volumetric_compensation",
}


def kind_of(name: str, data: bytes) -> Schema | None:
    """Return the kind of the list ``data`` in a file called ``name``, ``None`` if it is unclear.

    It is the schema with most of the entries, of several the one of the file name. A list in XML
    is identified by its outermost element, else by the IDs in it.
    """
    if is_xml(data):
        return _kind_of_xml(data)
    counts = _known_entries(_entries(name, data))
    maximum = max(counts.values())
    best = [schema for schema in SCHEMAS if counts[schema.kind] == maximum]
    by_name = [schema for schema in best if _NAMES[schema.kind].search(name.casefold())]
    if by_name:
        return by_name[0]
    return best[0] if maximum else None


def is_startup_list(path: Path, access: FileAccess) -> bool:
    """Return whether a file is a start-up list by its entries, regardless of its name."""
    try:
        return kind_of(path.name, access.read_bytes(path)) is STARTUP
    except Failure:
        return False


def knows_any(schema: Schema, entries: Sequence[Entry]) -> bool:
    """Return whether a kind of list has any of these entries."""
    return any(entry.is_well_formed and schema.find(entry.pattern) for entry in entries)


def other_kind(schema: Schema, name: str, data: bytes) -> Schema | None:
    """Return the kind of a list without any entry of ``schema``, ``None`` if it fits."""
    if is_xml(data):
        kind = _kind_of_xml(data)
        return None if kind is schema else kind
    patterns = _entries(name, data)
    if any(schema.find(pattern) is not None for pattern in patterns):
        return None
    return kind_of(name, data) if any(_known_entries(patterns).values()) else None


def _kind_of_xml(data: bytes) -> Schema | None:
    root, families = root_and_families(data)
    kind = _XML_ROOTS.get(root)
    if kind is None:
        kind = next((FAMILIES[family] for family in families if family in FAMILIES), None)
    return None if kind is None else SCHEMA_BY_KIND[kind]


def _entries(name: str, data: bytes) -> Counter[str]:
    """Return the names of the entries of a list with their counts."""
    entries = read_list(name, data, ListDialect(), Collector())
    return Counter(entry.pattern for entry in entries if entry.is_well_formed)


def _known_entries(patterns: Counter[str]) -> dict[str, int]:
    """Return the number of known entries for each kind of list."""
    return {
        schema.kind: sum(
            count for pattern, count in patterns.items() if schema.find(pattern) is not None
        )
        for schema in SCHEMAS
    }


def check_list_alone(
    schema: Schema,
    path: Path,
    data: bytes,
    collector: Collector,
    *,
    detail: Detail = "summary",
    rtconf: RtconfOptions = STANDARD_OPTIONS,
) -> None:
    """Report the mistakes in the list of kind ``schema`` in ``path``."""
    file = path.as_posix()
    if schema is RTCONF:
        load_rtconf(file, data, collector, rtconf)
        return
    values = load_list(schema, file, data, collector, detail=detail)
    if schema is VARIABLES:
        variables_configuration(values, collector)


def references(startup: StartupConfiguration) -> Iterator[tuple[str, ListReference]]:
    """Yield the lists that a start-up list names, each with its kind."""
    links = [("rtconf", startup.rtconf), ("axis", startup.axis_defaults)]
    links += [("axis", reference) for reference in startup.axes]
    links.append(("channel", startup.channel_defaults))
    for channel in startup.channels:
        links += [("channel", channel.parameters), ("variables", channel.variables)]
        links += [("tools", channel.tools), ("zero_offsets", channel.zero_offsets)]
        links.append(("clamp_offsets", channel.clamp_offsets))
    for kind, reference in links:
        if reference is not None:
            yield kind, reference
    yield from startup.others
