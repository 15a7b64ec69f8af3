# SPDX-License-Identifier: MIT
"""Diagnostics of mistakes in the words of the command line.

In: the error of click, the words. Out: a diagnostic on standard error, in the language of help.
"""

from __future__ import annotations

import os
from collections.abc import Sequence

import click

from nctakt.base.diagnostics import LANGUAGE_VARIABLE, NOTHING, Diagnostic, Text
from nctakt.base.misspelling import nearest
from nctakt.cli.common.help import RepeatedOptionError, help_language
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import (
    ARGUMENT_MISSING,
    INVALID_COMMAND_LINE,
    INVALID_OPTION_VALUE,
    OPTION_REPEATED,
    OPTION_VALUE_MISSING,
    UNKNOWN_OPTION,
    UNKNOWN_SUBCOMMAND,
)
from nctakt.run.options import FRONT_ENDS, refused


def report_usage(error: click.ClickException, words: Sequence[str]) -> None:
    """Show the mistake, and the command for the help."""
    print_diagnostics([_diagnostic(error)], help_language(words))


def _diagnostic(error: click.ClickException) -> Diagnostic:
    context = getattr(error, "ctx", None)
    help_of = f"{context.command_path} --help" if context is not None else "nctakt --help"
    match error:
        case click.NoSuchOption():
            found = _of_others(error.option_name, context)
            if found is not None:
                return found
            near = nearest(error.option_name, _options(context)) or NOTHING
            return diagnostic(UNKNOWN_OPTION, option=error.option_name, nearest=near, help=help_of)
        case click.MissingParameter():
            return diagnostic(ARGUMENT_MISSING, name=_name(error), help=help_of)
        case click.BadParameter():
            expected = _expected(error)
            return diagnostic(
                INVALID_OPTION_VALUE,
                name=_name(error),
                value=_value(error),
                expected=expected,
                help=help_of,
            )
        case click.BadOptionUsage() if error.option_name:
            return diagnostic(OPTION_VALUE_MISSING, option=error.option_name, help=help_of)
        case RepeatedOptionError():
            return diagnostic(OPTION_REPEATED, option=error.option)
        case click.UsageError():
            return _of_command(error, context, help_of)
    return diagnostic(INVALID_COMMAND_LINE, reason=error.format_message(), help=help_of)


def _of_others(option: str, context: click.Context | None) -> Diagnostic | None:
    """Return the diagnostic of a run option that other commands have (902380), else ``None``."""
    command = "" if context is None else context.command.name or ""
    return refused(option, command) if command in FRONT_ENDS else None


def _of_command(error: click.UsageError, context: click.Context | None, help_of: str) -> Diagnostic:
    """Return the diagnostic of an unknown subcommand, else one with click's text."""
    command = None if context is None else context.command
    written = error.message.split("'")
    if isinstance(command, click.Group) and context is not None and len(written) == 3:
        names = command.list_commands(context)
        near = nearest(written[1], names) or _begun(written[1], names) or NOTHING
        return diagnostic(UNKNOWN_SUBCOMMAND, word=written[1], nearest=near, names=", ".join(names))
    return diagnostic(INVALID_COMMAND_LINE, reason=error.message, help=help_of)


def _begun(word: str, names: Sequence[str]) -> str:
    """Return the only subcommand that begins with a word; empty if none or several do."""
    begun = [name for name in names if name.startswith(word.lower())]
    return begun[0] if len(begun) == 1 else ""


def _options(context: click.Context | None) -> list[str]:
    """Return all spellings of the command's options."""
    if context is None:
        return []
    parameters = context.command.params
    return [
        spelling
        for parameter in parameters
        for spelling in (*parameter.opts, *parameter.secondary_opts)
    ] + list(context.help_option_names)


def _value(error: click.BadParameter) -> str:
    """Return the value quoted in click's text."""
    return error.message.partition(" is not ")[0].strip("'")


def _expected(error: click.BadParameter) -> Text:
    """Return the values that the parameter accepts."""
    kind = None if error.param is None else error.param.type
    if isinstance(kind, click.Choice):
        choices = ", ".join(str(choice) for choice in kind.choices)
        return Text(f"one of {choices}", f"eines von {choices}")
    if isinstance(kind, click.IntRange | click.FloatRange):
        low, high = kind.min, kind.max
        is_integer = isinstance(kind, click.IntRange)
        en = "a whole number" if is_integer else "a number"
        de = "eine ganze Zahl" if is_integer else "eine Zahl"
        if high is None:
            return Text(f"{en} from {low} on", f"{de} ab {low}")
        return Text(f"{en} from {low} to {high}", f"{de} von {low} bis {high}")
    return Text(error.message, error.message)


def _name(error: click.BadParameter) -> str:
    """Return the parameter's name for the user: ``--ticks``, ``FILE``."""
    parameter = error.param
    if parameter is None:
        return error.param_hint if isinstance(error.param_hint, str) else NOTHING
    if isinstance(parameter, click.Option):
        in_environment = os.environ.get(LANGUAGE_VARIABLE) == _value(error)
        if parameter.envvar == LANGUAGE_VARIABLE and in_environment:
            return LANGUAGE_VARIABLE
        return max(parameter.opts, key=len)
    return parameter.human_readable_name
