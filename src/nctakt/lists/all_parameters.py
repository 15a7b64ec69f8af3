# SPDX-License-Identifier: MIT
"""All parameters of all lists, for explanation and documentation.

In: an ID (``P-CHAN-00425``) or a name (``rt_cycles.max_duration``). Out: the declarations.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.schemas import (
    AXIS,
    AXIS_COMPENSATION,
    CHANNEL,
    CLAMP_OFFSETS,
    HARDWARE,
    LIST_DESCRIPTION,
    MANUAL_MODE,
    RTCONF,
    SCENE,
    STARTUP,
    TOOLS,
    VARIABLES,
    VOLUMETRIC_COMPENSATION,
    ZERO_OFFSETS,
)
from nctakt.lists.format.parameter import Parameter
from nctakt.lists.format.schema import Schema

#: Every kind of list, in the order in which a controller reads them.
SCHEMAS: tuple[Schema, ...] = (
    STARTUP,
    CHANNEL,
    AXIS,
    VARIABLES,
    TOOLS,
    ZERO_OFFSETS,
    CLAMP_OFFSETS,
    RTCONF,
    AXIS_COMPENSATION,
    MANUAL_MODE,
    VOLUMETRIC_COMPENSATION,
    SCENE,
    HARDWARE,
    LIST_DESCRIPTION,
)

#: The letters in the IDs of parameters -> their kind of list.
FAMILIES = {
    "AXIS": "axis",
    "CHAN": "channel",
    "CLMP": "clamp_offsets",
    "CMLD": "list_description",
    "COMP": "axis_compensation",
    "EXTV": "variables",
    "HWCF": "hardware",
    "MANU": "manual_mode",
    "RTCF": "rtconf",
    "SECO": "scene",
    "STUP": "startup",
    "TOOL": "tools",
    "VOLC": "volumetric_compensation",
    "ZERO": "zero_offsets",
}
SCHEMA_BY_KIND: dict[str, Schema] = {schema.kind: schema for schema in SCHEMAS}

_INDEX = re.compile(r"\[[^]]*\]")
_ID = re.compile(r"(?:P-)?([A-Z]{4})-([0-9]{1,5})")
_NUMBER = re.compile(r"0[0-9]{4}")


@dataclass(frozen=True, slots=True)
class DeclaredParameter:
    """A parameter and its kind of list."""

    schema: Schema
    parameter: Parameter


def find_parameters(name: str) -> tuple[DeclaredParameter, ...]:
    """Return the parameters with an ID or name; indices and an ID's letter case are ignored."""
    pattern = _INDEX.sub("[]", name)
    parameters: list[DeclaredParameter] = []
    for schema in SCHEMAS:
        by_name = schema.find(pattern)
        if by_name is not None:
            parameters.append(DeclaredParameter(schema, by_name[0]))
        for parameter in schema.by_id(name.upper()):
            if by_name is None or parameter is not by_name[0]:
                parameters.append(DeclaredParameter(schema, parameter))
    return tuple(parameters)


def similar_parameters(name: str) -> tuple[DeclaredParameter, ...]:
    """Return the parameters with a part of a name or ID: ``vb_max``, ``CHAN-425``, ``00425``.

    Indices and letter case do not matter, and leading parts may be missing.
    """
    end, ids = _plain(name), _ids(name.upper())
    return tuple(
        DeclaredParameter(schema, parameter)
        for schema in SCHEMAS
        for parameter in schema.parameters
        if parameter.id in ids
        or any(_ends_with(parameter_name, end) for parameter_name in _names_of(parameter))
    )


def _ids(word: str) -> tuple[str, ...]:
    if _NUMBER.fullmatch(word):
        kinds = {
            parameter.id[:7]
            for schema in SCHEMAS
            for parameter in schema.parameters
            if parameter.id
        }
        return tuple(f"{kind}{word}" for kind in sorted(kinds))
    written = _ID.fullmatch(word)
    return () if written is None else (f"P-{written[1]}-{written[2]:0>5}",)


def _names_of(parameter: Parameter) -> Iterator[str]:
    yield _plain(parameter.path)
    for alias in parameter.aliases:
        yield _plain(alias.path)


def _plain(name: str) -> str:
    return _INDEX.sub("", name).lower()


def _ends_with(name: str, end: str) -> bool:
    return bool(end) and f".{name}".endswith(f".{end}")
