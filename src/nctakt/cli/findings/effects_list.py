# SPDX-License-Identifier: MIT
"""Entries of lists that would change a run on the machine, as a table for a reader.

In: findings of ``nctakt check --effects``. Out: lines. A folder of a real machine has hundreds of
such entries: one line and its meaning for each, below its file, and the remedy once.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import click

from nctakt.base.diagnostics import Diagnostic, Language, Severity, Text
from nctakt.messages.machines.lists import PARAMETER_MAY_CHANGE_RUN, PARAMETER_WOULD_CHANGE_RUN

#: The messages of such entries, each with its heading for one entry and for any other number.
_HEADINGS = {
    PARAMETER_WOULD_CHANGE_RUN: (
        Text(
            "{count} entry without effect here would change a run",
            "{count} Eintrag ohne Wirkung hier würde einen Lauf ändern",
        ),
        Text(
            "{count} entries without effect here would change a run",
            "{count} Einträge ohne Wirkung hier würden einen Lauf ändern",
        ),
    ),
    PARAMETER_MAY_CHANGE_RUN: (
        Text(
            "{count} entry without effect here may change a run",
            "{count} Eintrag ohne Wirkung hier kann einen Lauf ändern",
        ),
        Text(
            "{count} entries without effect here may change a run",
            "{count} Einträge ohne Wirkung hier können einen Lauf ändern",
        ),
    ),
}
_ROW = Text("{id:14} {key} is {value}, not {default}", "{id:14} {key} ist {value}, nicht {default}")


def is_listed(diagnostic: Diagnostic) -> bool:
    """Return whether a finding belongs into the table."""
    return diagnostic.message in _HEADINGS


def effect_lines(
    diagnostics: Sequence[Diagnostic], language: Language, colours: Mapping[Severity, str | None]
) -> Iterator[str]:
    """Yield the table of the findings among ``diagnostics`` for which ``is_listed`` is true."""
    for message, headings in _HEADINGS.items():
        listed = [one for one in diagnostics if one.message is message]
        if not listed:
            continue
        text = headings[len(listed) != 1].get(language).format(count=len(listed))
        severity = listed[0].severity
        heading = f"{severity.label(language)} {message.id}: {text}"
        yield click.style(heading, fg=colours[severity])
        file = ""
        for one in listed:
            assert one.span is not None
            if one.span.file != file:
                file = one.span.file
                yield f"  {file}"
            yield f"  {one.span.line:6}  {_ROW.get(language).format_map(one.values)}"
            meaning = one.values["meaning"]
            assert isinstance(meaning, Text)
            yield f"{'':10}{meaning.get(language)}"
        label = "Abhilfe" if language == "de" else "remedy"
        yield f"  {label}: {listed[0].remedy(language)}"
