# SPDX-License-Identifier: MIT
"""Options of several commands: the start block of a block search, the trust in a project."""

from __future__ import annotations

import click

from nctakt.project.trust import trusting

FROM_LINE_OPTION = click.option(
    "--from-line",
    type=click.IntRange(min=1),
    metavar="N",
    help="Begin the first program at the block in this line (block search).",
)
FROM_BLOCK_OPTION = click.option(
    "--from-block",
    type=click.IntRange(min=1),
    metavar="N",
    help="The same, by the block's N number.",
)


def _trust(context: click.Context, _parameter: click.Parameter, is_given: bool) -> None:
    """Trust all projects until the command has ended."""
    if is_given:
        context.with_resource(trusting())


TRUST_OPTION = click.option(
    "--trust",
    is_flag=True,
    expose_value=False,
    callback=_trust,
    help="Run the code that the project file names, whoever may write it.",
)
