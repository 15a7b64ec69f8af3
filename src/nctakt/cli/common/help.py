# SPDX-License-Identifier: MIT
"""Help of commands in both languages: options in groups, one wording of exit codes, examples.

In: ``Text`` for everything that help says. Out: click's commands and options that show it in the
language of ``--lang``, of ``NCTAKT_LANGUAGE`` or of the locale.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar, cast

import click

from nctakt.base.diagnostics import LANGUAGE_VARIABLE, Language, Text

#: The groups of options, in the order of the help.
GROUPS: Mapping[str, Text] = {
    "machine": Text("Machine, programs and PLC", "Maschine, Programme und SPS"),
    "run": Text("Values, limits, beginning", "Werte, Grenzen, Beginn"),
    "schedule": Text("Schedule", "Echtzeitkonfiguration"),
    "command": Text("Options of this command", "Optionen dieses Befehls"),
    "protocols": Text("Protocols", "Protokolle"),
    "files": Text("Results", "Ergebnisse"),
    "general": Text("General", "Allgemeines"),
}

#: The exit codes that all commands have in common; 0 and 1 have a text of each command.
_CODES = Text(
    "Exit codes: 0 {success}, 1 {failure}, 2 wrong usage or unusable input, 3 an error of nctakt "
    "itself.",
    "Rückgabewerte: 0 {success}, 1 {failure}, 2 falscher Aufruf oder unbrauchbare Eingabe, 3 ein "
    "Fehler von nctakt selbst.",
)
_CODES_WITHOUT_FAILURE = Text(
    "Exit codes: 0 {success}, 2 wrong usage or unusable input, 3 an error of nctakt itself.",
    "Rückgabewerte: 0 {success}, 2 falscher Aufruf oder unbrauchbare Eingabe, 3 ein Fehler von "
    "nctakt selbst.",
)
_USAGE = Text("Usage: ", "Aufruf: ")
_LANGUAGE = Text(
    "Language of help, texts and messages.", "Sprache der Hilfe, der Texte und Meldungen."
)
#: German names of the values in usage lines and options.
_GERMAN_VALUES: Mapping[str, str] = {
    "ADDRESS": "ADRESSE",
    "ARGS": "ARGUMENTE",
    "COMMAND": "BEFEHL",
    "FILE": "DATEI",
    "FOLDER": "ORDNER",
    "OPTIONS": "OPTIONEN",
    "PERCENT": "PROZENT",
    "PROGRAM": "PROGRAMM",
    "RECORDING": "AUFZEICHNUNG",
    "TIME": "ZEIT",
    "VALUE": "WERT",
    "WORD": "WORT",
}
_VALUE = re.compile(rf"\b({'|'.join(_GERMAN_VALUES)})\b")
#: Where a context keeps the language that a group's ``--lang`` names.
_GIVEN_LANGUAGE = "nctakt.language"
_EXAMPLES = Text("Examples", "Beispiele")
#: Words that ask for help, for every command, even called without the group.
HELP_NAMES = ["-h", "--help"]
_HELP = Text("Show this message and exit.", "Diese Hilfe zeigen.")

#: The exit codes of commands without their own text.
DONE = Text("done", "erledigt")

_Command = TypeVar("_Command", bound=Callable[..., Any])


def language_of_words(words: Sequence[str]) -> Language | None:
    """Return the language of ``--lang`` among the words of a command line, else ``None``."""
    for word, following in zip(words, [*words[1:], ""], strict=False):
        language = word.partition("=")[2] if word.startswith("--lang=") else following
        if word.startswith("--lang") and language in ("en", "de"):
            return cast(Language, language)
    return None


def help_language(words: Sequence[str]) -> Language:
    """Return the language of ``--lang``, ``NCTAKT_LANGUAGE``, the locale, else English.

    It is that of help, and of messages before a project is known.
    """
    named = language_of_words(words) or os.environ.get(LANGUAGE_VARIABLE)
    if named in ("en", "de"):
        return cast(Language, named)
    return locale_language()


def locale_language() -> Language:
    """Return the language of the locale, the default: German, else English."""
    names = ("LC_ALL", "LC_MESSAGES", "LANG")
    locale = next((os.environ[name] for name in names if os.environ.get(name)), "")
    return "de" if locale.lower().startswith("de") else "en"


def shown_language(context: click.Context) -> Language:
    """Return the language of the help that a context shows; ``main`` has put it there."""
    return "de" if context.find_root().obj == "de" else "en"


def _with_values(pieces: str, context: click.Context) -> str:
    """Return a usage line or an option with the names of its values in the language of the help."""
    if shown_language(context) == "en":
        return pieces
    return _VALUE.sub(lambda match: _GERMAN_VALUES[match[0]], pieces)


class GroupedOption(click.Option):
    """An option with its group and its help in both languages."""

    def __init__(self, *names: Any, texts: Text, group: str, **attributes: Any) -> None:
        super().__init__(*names, **{**attributes, "help": texts.en})
        self.texts = texts
        self.group = group

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        record = super().get_help_record(ctx)
        if record is None:
            return None
        text = record[1].replace(self.texts.en, self.texts.get(shown_language(ctx)), 1)
        return _with_values(record[0], ctx), text


class RepeatedOptionError(click.UsageError):
    """An option is repeated, and would replace its earlier value; ``option``: its name."""

    def __init__(self, option: str, context: click.Context) -> None:
        super().__init__(option, context)
        self.option = option


class LanguageOption(GroupedOption):
    """``--lang``: without it that of the group, else that of the environment."""

    def __init__(self, *names: Any, **attributes: Any) -> None:
        super().__init__(*names, **attributes, envvar=LANGUAGE_VARIABLE)

    def resolve_envvar_value(self, ctx: click.Context) -> str | None:
        return ctx.meta.get(_GIVEN_LANGUAGE) or super().resolve_envvar_value(ctx)


class NumberRange(click.FloatRange):
    """A range of numbers without NaN, which click admits to each."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the number; raises click's error."""
        number = super().convert(value, param, ctx)
        if math.isnan(number):
            self.fail(f"{value} is not in the range {self._describe_range()}.", param, ctx)
        return number


def option(
    *names: str, text: Text, group: str = "command", **attributes: Any
) -> Callable[[_Command], _Command]:
    """Return the decorator of an option with its help in both languages."""
    cls = LanguageOption if "--lang" in names else GroupedOption
    return click.option(*names, cls=cls, texts=text, group=group, **attributes)


def _is_said_once(option: click.Option) -> bool:
    """Return whether an option says something else when it is given again."""
    is_switch = option.is_flag and not option.secondary_opts
    return not (option.multiple or option.count or is_switch)


def _keep_language(
    context: click.Context, _parameter: click.Parameter, language: str | None
) -> None:
    """Give the subcommands of a group the language that precedes them on the command line."""
    if language is not None:
        context.meta[_GIVEN_LANGUAGE] = language


class _Shown(click.Command):
    """Common parts of commands and groups; the texts come from ``described``."""

    summary = Text("", "")
    text = Text("", "")
    notes = Text("", "")
    codes: tuple[Text, Text | None] = (DONE, None)
    examples: tuple[str, ...] = ()

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Attach the command whose help explains them to a mistake in the words."""
        words = list(args)
        try:
            left = super().parse_args(ctx, args)
            self._refuse_repetitions(ctx, words)
            return left
        except click.UsageError as error:
            error.ctx = error.ctx or ctx
            raise

    def _refuse_repetitions(self, ctx: click.Context, words: list[str]) -> None:
        """Raise ``RepeatedOptionError`` if a word would replace an earlier one of its option."""
        if ctx.resilient_parsing:
            return
        given = self.make_parser(ctx).parse_args(words)[2]
        for one in self.get_params(ctx):
            if isinstance(one, click.Option) and _is_said_once(one) and given.count(one) > 1:
                spellings = (one.opts, one.secondary_opts)
                option = "/".join(max(names, key=len) for names in spellings if names)
                raise RepeatedOptionError(option, ctx)

    def get_help_option(self, ctx: click.Context) -> click.Option | None:
        found = super().get_help_option(ctx)
        if found is not None:
            found.help = _HELP.get(shown_language(ctx))
        return found

    def get_short_help_str(self, limit: int = 45) -> str:
        context = click.get_current_context(silent=True)
        return self.summary.get("en" if context is None else shown_language(context))

    def format_usage(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        pieces = " ".join(self.collect_usage_pieces(ctx))
        usage = _USAGE.get(shown_language(ctx))
        formatter.write_usage(ctx.command_path, _with_values(pieces, ctx), usage)

    def format_help_text(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        formatter.write_paragraph()
        with formatter.indentation():
            formatter.write_text(self.text.get(shown_language(ctx)))

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        language = shown_language(ctx)
        records: dict[str, list[tuple[str, str]]] = {name: [] for name in GROUPS}
        for parameter in self.get_params(ctx):
            is_option = isinstance(parameter, click.Option)
            record = parameter.get_help_record(ctx) if is_option else None
            if record is not None:
                records[getattr(parameter, "group", "general")].append(record)
        for name, title in GROUPS.items():
            if records[name]:
                with formatter.section(title.get(language)):
                    formatter.write_dl(records[name])

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        language = shown_language(ctx)
        success, failure = self.codes
        codes = _CODES_WITHOUT_FAILURE if failure is None else _CODES
        words = {
            "success": success.get(language),
            "failure": "" if failure is None else failure.get(language),
        }
        for text in (self.notes.get(language), codes.get(language).format(**words)):
            if text:
                formatter.write_paragraph()
                formatter.write_text(text)
        if self.examples:
            with formatter.section(_EXAMPLES.get(language)):
                for line in self.examples:
                    formatter.write(f"{'':>{formatter.current_indent}}{line}\n")


class ShownCommand(_Shown):
    """A command whose help is in both languages."""


class ShownGroup(_Shown, click.Group):
    """A group of commands whose help is in both languages; ``--lang`` is for all of them."""

    def __init__(self, *words: Any, **attributes: Any) -> None:
        super().__init__(*words, **attributes)
        language = GroupedOption(
            ["--lang"],
            texts=_LANGUAGE,
            group="general",
            type=click.Choice(["en", "de"]),
            expose_value=False,
            callback=_keep_language,
        )
        self.params.append(language)

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        _Shown.format_options(self, ctx, formatter)
        self.format_commands(ctx, formatter)


def described(
    name: str,
    *,
    summary: Text,
    text: Text,
    codes: tuple[Text, Text | None] = (DONE, None),
    notes: Text | None = None,
    examples: Sequence[str] = (),
) -> Callable[[Callable[..., Any]], click.Command]:
    """Return the decorator of a subcommand.

    ``summary``: a line for the list of commands; ``text``: its description; ``codes``: meanings of
    the exit codes 0 and 1, ``None`` for 1 if there is none; ``examples``: command lines.
    """
    described_command: Callable[[Callable[..., Any]], click.Command] = _shown(
        click.command, ShownCommand, name, summary, text, codes, notes, examples
    )
    return described_command


def described_group(
    name: str,
    *,
    summary: Text,
    text: Text,
    codes: tuple[Text, Text | None] = (DONE, None),
    notes: Text | None = None,
    examples: Sequence[str] = (),
) -> Callable[[Callable[..., Any]], click.Group]:
    """Return the decorator of a subcommand that has subcommands; as ``described``."""
    described_command: Callable[[Callable[..., Any]], click.Group] = _shown(
        click.group, ShownGroup, name, summary, text, codes, notes, examples
    )
    return described_command


def _shown(
    make: Callable[..., Any],
    cls: type[click.Command],
    name: str,
    summary: Text,
    text: Text,
    codes: tuple[Text, Text | None],
    notes: Text | None,
    examples: Sequence[str],
) -> Any:
    """Return a decorator that makes a command and gives it its texts."""

    def decorate(function: Callable[..., Any]) -> Any:
        described_command = make(
            name,
            cls=cls,
            help=text.en,
            short_help=summary.en,
            context_settings={"help_option_names": HELP_NAMES},
        )(function)
        described_command.summary, described_command.text, described_command.codes = (
            summary,
            text,
            codes,
        )
        described_command.notes = notes or Text("", "")
        described_command.examples = tuple(examples)
        return described_command

    return decorate
