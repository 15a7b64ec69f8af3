# SPDX-License-Identifier: MIT
"""All parameters of all lists, for explanation and documentation.

In: an ID (``P-CHAN-00425``) or a name (``rt_cycles.max_duration``). Out: the declarations.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from nctakt.lists.axis import AXIS
from nctakt.lists.channel import CHANNEL
from nctakt.lists.offsets import CLAMP_OFFSETS, ZERO_OFFSETS
from nctakt.lists.parameter import Parameter, Schema
from nctakt.lists.rtconf import RTCONF
from nctakt.lists.startup import STARTUP
from nctakt.lists.tools import TOOLS
from nctakt.lists.variables import VARIABLES

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
)

_INDEX = re.compile(r"\[[^]]*\]")


@dataclass(frozen=True, slots=True)
class DeclaredParameter:
    """A parameter and the kind of list it stands in."""

    schema: Schema
    parameter: Parameter


def find_parameters(name: str) -> tuple[DeclaredParameter, ...]:
    """The parameters of that ID or name; indices are ignored, letter case in an ID too."""
    pattern = _INDEX.sub("[]", name)
    found: list[DeclaredParameter] = []
    for schema in SCHEMAS:
        by_name = schema.find(pattern)
        if by_name is not None:
            found.append(DeclaredParameter(schema, by_name[0]))
        found += [DeclaredParameter(schema, one) for one in schema.by_id(name.upper())]
    return tuple(found)
