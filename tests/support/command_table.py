# SPDX-License-Identifier: MIT
"""The commands of ``nctakt``, as its own table has them."""

from collections.abc import Iterator

import click


def commands(parent: click.Group, *before: str) -> Iterator[list[str]]:
    """The words of each subcommand, those of a subcommand such as ``schedule show`` included."""
    context = click.Context(parent)
    for name in parent.list_commands(context):
        yield [*before, name]
        command = parent.get_command(context, name)
        if isinstance(command, click.Group):
            yield from commands(command, *before, name)
