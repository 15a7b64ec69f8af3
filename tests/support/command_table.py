# SPDX-License-Identifier: MIT
"""The commands of ``nctakt``, as its own table has them."""

from collections.abc import Iterator, Sequence

import click

from nctakt.cli import group


def commands(parent: click.Group, *before: str) -> Iterator[list[str]]:
    """The words of each subcommand, those of a subcommand such as ``schedule show`` included."""
    context = click.Context(parent)
    for name in parent.list_commands(context):
        yield [*before, name]
        command = parent.get_command(context, name)
        if isinstance(command, click.Group):
            yield from commands(command, *before, name)


def command_of(words: Sequence[str]) -> click.Command:
    """Return the command of the words of a command line."""
    command: click.Command = group
    for word in words:
        assert isinstance(command, click.Group)
        found = command.get_command(click.Context(command), word)
        assert found is not None
        command = found
    return command
