# SPDX-License-Identifier: MIT
"""The language of what a command tells: ``--lang``, else ``NCTAKT_LANGUAGE``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from nctakt.base.diagnostics import Language

#: The environment variable for the language.
LANGUAGE_VARIABLE = "NCTAKT_LANGUAGE"

_Command = TypeVar("_Command", bound=Callable[..., Any])


def language_option(
    meaning: str, default: Language | None = "en"
) -> Callable[[_Command], _Command]:
    """Return the option as a decorator; ``None``: the project file decides, else English."""
    return click.option(
        "--lang",
        "language",
        type=click.Choice(["en", "de"]),
        default=default,
        envvar=LANGUAGE_VARIABLE,
        help=meaning,
    )
