# SPDX-License-Identifier: MIT
"""A list alone -> which kind it is, and what is wrong with it.

In: the bytes of one list. Out: the schema that knows most of its entries, diagnostics. What depends
on other lists (values of a defaults list, axes that the start-up list does not have) is not
checked here but with the machine's folder (``machine.py``).
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.declared.rtconf import RTCONF
from nctakt.lists.declared.startup import (
    STARTUP,
    ListReference,
    StartupConfiguration,
    startup_configuration,
)
from nctakt.lists.declared.variables import VARIABLES
from nctakt.lists.format.parameter import Schema
from nctakt.lists.format.reader import ListDialect, read_list
from nctakt.lists.format.schema import load_list
from nctakt.lists.machine.files import find_list
from nctakt.lists.machine.scheduling import load_rtconf
from nctakt.lists.machine.variables import variables_configuration
from nctakt.messages import Collector
from nctakt.messages.machine import LIST_FORMAT_NOT_SUPPORTED

#: How files of each kind are called in the field, for lists whose entries tell nothing.
_NAMES = {
    "startup": re.compile("hochlauf|startup"),
    "channel": re.compile("sda_mds|default_sda|kanal|channel"),
    "axis": re.compile("achs_mds|default_achs|ax_mds|axis|achse"),
    "variables": re.compile("ext_var|ve_var|v_ch|extv"),
    "tools": re.compile("werkz|tool"),
    "zero_offsets": re.compile("nullp|zero"),
    "clamp_offsets": re.compile("pzv|platz|clamp"),
    "rtconf": re.compile("rtconf"),
}


def kind_of(name: str, data: bytes) -> Schema | None:
    """The kind of the list ``data`` in a file called ``name``; ``None`` where nothing tells it.

    The schema that knows most of the entries counts; of several the one that the name fits.
    """
    known = _known_entries(name, data)
    most = max(known.values())
    best = [schema for schema in SCHEMAS if known[schema.kind] == most]
    named = [schema for schema in best if _NAMES[schema.kind].search(name.casefold())]
    if named:
        return named[0]
    return best[0] if most else None


def other_kind(schema: Schema, name: str, data: bytes) -> Schema | None:
    """The kind of a list that is named as one of ``schema`` and has no entry of it at all."""
    known = _known_entries(name, data)
    if known[schema.kind] or not any(known.values()):
        return None
    return kind_of(name, data)


def _known_entries(name: str, data: bytes) -> dict[str, int]:
    """How many entries each kind of list knows."""
    entries = read_list(name, data, ListDialect(), Collector())
    patterns = Counter(entry.pattern for entry in entries if entry.is_well_formed)
    return {
        schema.kind: sum(count for one, count in patterns.items() if schema.find(one) is not None)
        for schema in SCHEMAS
    }


def check_list_alone(
    schema: Schema, path: Path, data: bytes, collector: Collector, *, verbose: bool = False
) -> None:
    """Report what is wrong with the list of kind ``schema`` in ``path``."""
    file = path.as_posix()
    if schema is RTCONF:
        load_rtconf(file, data, collector)
        return
    values = load_list(schema, file, data, collector, verbose=verbose)
    if schema is VARIABLES:
        variables_configuration(values, collector)
    elif schema is STARTUP:
        if values.text("listen") != "ASCII":
            values.report(
                collector, LIST_FORMAT_NOT_SUPPORTED, ("listen",), format=values.text("listen")
            )
            return
        for _, reference in references(startup_configuration(values, collector)):
            find_list(reference, path.parent, collector)


def references(startup: StartupConfiguration) -> Iterator[tuple[str, ListReference]]:
    """The lists that a start-up list names, each with its kind."""
    named = [("rtconf", startup.rtconf), ("axis", startup.axis_defaults)]
    named += [("axis", reference) for reference in startup.axes]
    named.append(("channel", startup.channel_defaults))
    for channel in startup.channels:
        named += [("channel", channel.parameters), ("variables", channel.variables)]
        named += [("tools", channel.tools), ("zero_offsets", channel.zero_offsets)]
        named.append(("clamp_offsets", channel.clamp_offsets))
    for kind, reference in named:
        if reference is not None:
            yield kind, reference
