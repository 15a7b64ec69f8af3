# SPDX-License-Identifier: MIT
"""The options that name the start block of a block search."""

from __future__ import annotations

import click

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
