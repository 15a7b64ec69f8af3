# SPDX-License-Identifier: MIT
"""Each of the 1,766 published parameters: declared, explained in both languages, checked.

A list that gives every parameter its default has no finding, one that gives each a wrong value has
one for each.
"""

from __future__ import annotations

from collections import Counter

import pytest

from nctakt.lists.all_parameters import SCHEMA_BY_KIND, SCHEMAS, find_parameters
from nctakt.lists.format.list_check import load_list
from nctakt.lists.format.parameter import Parameter, ValueType, shown
from nctakt.lists.format.schema import Schema
from nctakt.messages import Collector
from nctakt.reference.parameters import CONCERNS, article

#: Kind of list -> what its IDs begin with, and their numbers.
PUBLISHED = {
    "axis": (
        "AXIS",
        "1-110 112-488 490-548 554-557 561-662 675-702 704-705 707-784 786 789-797 803 813-826",
    ),
    "channel": (
        "CHAN",
        "1-93 95-200 208-236 238-241 243-271 273-301 305-315 321-334 337-351 353-358 "
        "360-405 408-411 415-423 428-429 431-442 446-451 453 455-460 463-464 466-479 "
        "481-496 498 500-524 550-555 600-607 609 650-657 659 700-706 751-752 754-762 "
        "800-835 851-852",
    ),
    "clamp_offsets": (
        "CLMP",
        "1",
    ),
    "list_description": (
        "CMLD",
        "1-4",
    ),
    "axis_compensation": (
        "COMP",
        "1-33 40-49 57-72 74-77 80-90",  # and 79, of which only a number is published: 110670
    ),
    "variables": (
        "EXTV",
        "1-12 15-22 30-47",
    ),
    "hardware": (
        "HWCF",
        "1-7",
    ),
    "manual_mode": (
        "MANU",
        "1-15",
    ),
    "rtconf": (
        "RTCF",
        "1-14 17-18",
    ),
    "scene": (
        "SECO",
        "1-10 20-22 25-28 60-61 80-87 100-105",
    ),
    "startup": (
        "STUP",
        "1-3 5-27 29 31-37 39-45 50-55 60-64 70-75 80-82 90-94 100-101 110-120 130-158 "
        "160-181 183-202 213-215",
    ),
    "tools": (
        "TOOL",
        "1-20 30-31 33-34 100-109 120-129 132 138 140-145 147",
    ),
    "volumetric_compensation": (
        "VOLC",
        "1-23",
    ),
    "zero_offsets": (
        "ZERO",
        "1-4",
    ),
}
COUNT = 1766
#: Kinds whose lists need an End line.
NEEDS_END = "rtconf"


def published(kind: str) -> list[str]:
    """The IDs of a kind of list."""
    family, ranges = PUBLISHED[kind]
    numbers: list[int] = []
    for part in ranges.split():
        first, _, last = part.partition("-")
        numbers += range(int(first), int(last or first) + 1)
    return [f"P-{family}-{number:05}" for number in numbers]


def at_zero(parameter: Parameter) -> str:
    """The name with all indices at their lowest value."""
    return parameter.pattern.replace("[]", "[0]")


def numbers(schema: Schema, lines: list[str]) -> Counter[int]:
    """What is found in a list of these lines: messages, whatever the number of their case."""
    collector = Collector()
    text = "".join(f"{line}\n" for line in (*lines, "End"))
    load_list(schema, "x.lis", text.encode(), collector)
    return Counter(diagnostic.message.id for diagnostic in collector.diagnostics)


def test_all_kinds_are_there() -> None:
    """1,766 published parameters of 14 kinds of lists."""
    assert PUBLISHED.keys() == SCHEMA_BY_KIND.keys()
    assert sum(len(published(kind)) for kind in PUBLISHED) == COUNT


@pytest.mark.parametrize("kind", PUBLISHED)
def test_each_published_parameter_is_declared_and_explained(kind: str) -> None:
    """By its ID, in its list, with a meaning in both languages."""
    for id_ in published(kind):
        found = [declared for declared in find_parameters(id_) if declared.schema.kind == kind]
        assert found, id_
        for declared in found:
            parameter = declared.parameter
            assert parameter.id == id_ or id_ in {alias.id for alias in parameter.aliases}
            assert parameter.text.en and parameter.text.de, id_
            assert parameter.text.en != parameter.text.de, id_
            shown = article(declared.schema, parameter)
            assert shown.name.count(parameter.id) == 1
            facts = shown.facts
            assert all(fact.value.en and fact.value.de for fact in facts), id_


@pytest.mark.parametrize("schema", SCHEMAS, ids=[schema.kind for schema in SCHEMAS])
def test_each_default_keeps_its_range(schema: Schema) -> None:
    """A list that gives all parameters their defaults has no finding at all."""
    lines = [
        f"{at_zero(parameter)} {parameter.default_id or quoted(parameter)}"
        for parameter in schema.parameters
        if (parameter.default or parameter.default == 0 or parameter.default_id)
        # Not configured, which is no source of an interrupt.
        and parameter.id != "P-RTCF-00001"
    ]
    assert numbers(schema, lines) == Counter()


def quoted(parameter: Parameter) -> str:
    """The default as a list writes it, texts in quotation marks."""
    text = shown(parameter.default)
    return f'"{text}"' if parameter.type is ValueType.STRING else text


@pytest.mark.parametrize("schema", SCHEMAS, ids=[schema.kind for schema in SCHEMAS])
def test_each_wrong_type_is_reported(schema: Schema) -> None:
    """A word where a number, a truth value or a name belongs; a text that is too long."""
    wrong = []
    for parameter in schema.parameters:
        if parameter.type is ValueType.STRING:
            if parameter.high is not None:
                wrong.append(f'{at_zero(parameter)} "{"x" * (int(parameter.high) + 1)}"')
        elif not parameter.has_more_names:
            wrong.append(f"{at_zero(parameter)} ?!")
    found = numbers(schema, wrong)
    assert found.keys() <= {2022, 1021, 2021, 1019, 20764, 21196}
    assert found.total() == len(wrong)


@pytest.mark.parametrize("schema", SCHEMAS, ids=[schema.kind for schema in SCHEMAS])
def test_each_number_out_of_its_range_is_reported(schema: Schema) -> None:
    """One below the lowest and one above the highest value, also of each type."""
    for step in (-1, 1):
        outside = []
        for parameter in schema.parameters:
            bound = parameter.bounds[step > 0] if parameter.type.is_number else float("inf")
            if abs(bound) != float("inf") and not parameter.allows(bound + step):
                outside.append(f"{at_zero(parameter)} {bound + step}")
        found = numbers(schema, outside)
        assert (found[900019], found.total()) == (len(outside), len(outside))


@pytest.mark.parametrize("schema", SCHEMAS, ids=[schema.kind for schema in SCHEMAS])
def test_each_index_out_of_its_range_is_reported(schema: Schema) -> None:
    """One above the last element, in each index; and no index has more than 65,536."""
    outside = []
    for parameter in schema.parameters:
        for number, (_, high) in enumerate(parameter.index_ranges):
            assert high < 65_536
            indices = ["[0]"] * len(parameter.index_ranges)
            indices[number] = f"[{high + 1}]"
            name = parameter.pattern
            for index in indices:
                name = name.replace("[]", index, 1)
            outside.append(f"{name} 0")
    found = numbers(schema, outside)
    assert (found[2009], found.total()) == (len(outside), len(outside))


def test_what_parameters_are_about_has_a_german_name() -> None:
    """The words of the column ``concern``."""
    concerns = {one.concern for schema in SCHEMAS for one in schema.parameters} - {""}
    assert concerns == CONCERNS.keys()
