# SPDX-License-Identifier: MIT
"""The command ``nctakt``: subcommands, each in its own file, and the exit codes.

In: the words of the command line. Out: 0 for success, 1 for an NC error or an interrupt, 2 for
wrong usage (an invalid option, file or machine), 3 for an internal error of nctakt. SIGTERM
interrupts as Ctrl-C does. A subcommand's module is loaded when it is called, so that none waits for
the libraries of another. ``NCTAKT_DEBUG=1`` shows the traceback of an internal error.
"""

from __future__ import annotations

import gc
import importlib
import os
import signal
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

import click

from nctakt.base.diagnostics import Language, Text
from nctakt.base.interrupts import handling
from nctakt.base.version import __version__
from nctakt.cli.common.help import HELP_NAMES, ShownGroup, help_language, option, shown_language
from nctakt.cli.common.terminal import complain, complain_notes, print_diagnostics, silence

EXIT_RAN = 0
EXIT_NC_ERROR = 1
EXIT_USAGE = 2
EXIT_INTERNAL = 3

#: The number of standard error; standard input is 0.
_HIGHEST_STREAM = 2

#: New objects between two garbage collections. Imports create a hundred thousand that all stay:
#: Python's default of 700 would cost a fifth of the time from the start to the first tick.
_OBJECTS_BETWEEN_SEARCHES = 50_000

#: Subcommands in groups, in the order of the help, and the modules that hold them as ``command``.
_GROUPS: Mapping[Text, Mapping[str, str]] = {
    Text("Start", "Beginnen"): {
        "demo": "nctakt.cli.demo",
        "init": "nctakt.cli.init",
        "new": "nctakt.cli.new",
        "check": "nctakt.cli.check",
        "run": "nctakt.cli.run",
    },
    Text("Look", "Ansehen"): {
        "live": "nctakt.cli.live",
        "why": "nctakt.cli.why",
        "time": "nctakt.cli.time",
        "compare": "nctakt.cli.compare",
        "coverage": "nctakt.cli.coverage",
        "disassemble": "nctakt.cli.disassemble",
        "explain": "nctakt.cli.explain",
    },
    Text("Test", "Testen"): {
        "test": "nctakt.cli.test",
        "study": "nctakt.cli.study",
        "replay": "nctakt.cli.replay",
        "schedule": "nctakt.cli.schedule",
    },
    Text("Connect", "Verbinden"): {
        "serve": "nctakt.cli.serve",
        "fmu": "nctakt.cli.fmu",
        "dap": "nctakt.cli.dap",
        "lsp": "nctakt.cli.lsp",
    },
}
_COMMANDS = {name: module for names in _GROUPS.values() for name, module in names.items()}

#: Earlier names of subcommands, which work for a version.
EARLIER_NAMES = {"list": "disassemble"}


class _LazyGroup(ShownGroup):
    """Loads the module of a subcommand when it is needed; help has the commands in groups."""

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        language = shown_language(ctx)
        for title, names in _GROUPS.items():
            rows = []
            for name in names:
                command = self.get_command(ctx, name)
                assert command is not None
                rows.append((name, command.get_short_help_str()))
            with formatter.section(title.get(language)):
                formatter.write_dl(rows)

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        from nctakt.cli.common.overview import path_lines  # noqa: PLC0415 - only for help

        formatter.write_paragraph()
        for line in path_lines(shown_language(ctx), Path()):
            formatter.write(f"{line}\n")

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(_COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name in EARLIER_NAMES:
            _report_new_name(ctx, cmd_name)
            cmd_name = EARLIER_NAMES[cmd_name]
        if cmd_name not in _COMMANDS:
            return None
        command = importlib.import_module(_COMMANDS[cmd_name]).command
        assert isinstance(command, click.Command)
        return command


def _report_new_name(context: click.Context, name: str) -> None:
    """Show the note that a subcommand has another name now (902381)."""
    from nctakt.messages import diagnostic  # noqa: PLC0415 - only an earlier name needs it
    from nctakt.messages.commands.command_line import COMMAND_RENAMED  # noqa: PLC0415

    found = diagnostic(COMMAND_RENAMED, name=name, new_name=EARLIER_NAMES[name])
    print_diagnostics([found], "de" if context.obj == "de" else "en")


_TEXT = Text(
    "A virtual CNC controller that runs NC programs with realtime cycles tick by tick.",
    "Eine virtuelle CNC-Steuerung, die NC-Programme mit Echtzeit-Zyklen Takt für Takt ausführt.",
)


@click.group(
    "nctakt",
    cls=_LazyGroup,
    help=_TEXT.en,
    invoke_without_command=True,
    context_settings={"help_option_names": HELP_NAMES},
)
@option(
    "--version",
    is_flag=True,
    group="general",
    text=Text("Show the version.", "Die Version zeigen."),
)
@option(
    "--verbose",
    is_flag=True,
    group="general",
    text=Text(
        "With --version: what a report of a fault needs.",
        "Mit --version: was ein Fehlerbericht braucht.",
    ),
)
@click.pass_context
def group(context: click.Context, version: bool, verbose: bool) -> int:
    """Show the version or, without a subcommand, the help."""
    if version and verbose:
        from nctakt.cli.common.overview import version_lines  # noqa: PLC0415 - only for this

        click.echo("\n".join(version_lines()))
        context.exit(EXIT_RAN)
    if version:
        click.echo(f"nctakt, version {__version__}")
        context.exit(EXIT_RAN)
    if context.invoked_subcommand is None:
        click.echo(context.get_help(), err=True)
    return EXIT_USAGE


group.text = _TEXT


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command and return its exit code; default ``arguments``: those of the process."""
    gc.set_threshold(_OBJECTS_BETWEEN_SEARCHES)
    _open_streams()
    _never_fail_at_a_character()
    code = EXIT_RAN
    try:
        with handling(signal.default_int_handler, only_termination=True):
            code = _run(arguments)
        if not sys.stdout.closed:  # a language server closes it at its end
            sys.stdout.flush()
    except BrokenPipeError as error:  # the reader has closed the pipe
        silence(sys.stdout)
        complain_notes(error)
    except OSError as error:  # standard output refuses the text
        return _refused(error, help_language(sys.argv[1:] if arguments is None else arguments))
    return code


def _run(arguments: Sequence[str] | None) -> int:
    try:
        words = sys.argv[1:] if arguments is None else arguments
        code = group.main(
            arguments, prog_name="nctakt", standalone_mode=False, obj=help_language(words)
        )
    except click.ClickException as error:
        from nctakt.cli.common.usage import report_usage  # noqa: PLC0415 - only a mistake needs it

        words = sys.argv[1:] if arguments is None else arguments
        report_usage(error, words)
        return EXIT_USAGE
    except (click.Abort, KeyboardInterrupt) as error:
        complain("interrupted")
        complain_notes(error)
        return EXIT_NC_ERROR
    except OSError:
        raise
    except Exception as error:  # noqa: BLE001 - the last resort, reported as an internal error
        return _internal_error(error)
    return code if isinstance(code, int) else EXIT_RAN


def _open_streams() -> None:
    """Open closed standard streams on the null device: else a file would get their numbers."""
    if None in (sys.stdin, sys.stdout, sys.stderr):
        number = os.open(os.devnull, os.O_RDWR)
        while number <= _HIGHEST_STREAM:
            number = os.dup(number)
        os.close(number)
    if sys.stdout is None:
        sys.stdout = open(1, "w", encoding="utf-8", closefd=False)
    if sys.stderr is None:
        sys.stderr = open(2, "w", encoding="utf-8", closefd=False)


def _refused(error: OSError, language: Language) -> int:
    """Report that the system refuses output, or has no working directory; return exit code 2."""
    from nctakt.messages import diagnostic  # noqa: PLC0415 - only a mistake needs it
    from nctakt.messages.files import FILE_NOT_WRITABLE, NO_WORKING_DIRECTORY  # noqa: PLC0415

    _trace_if_debugging(error)
    silence(sys.stdout)
    complain_notes(error)
    if _is_nowhere():
        print_diagnostics([diagnostic(NO_WORKING_DIRECTORY)], language)
        return EXIT_USAGE
    name = "standard output" if error.filename is None else str(error.filename)
    reason = error.strerror or str(error)
    print_diagnostics([diagnostic(FILE_NOT_WRITABLE, file=name, reason=reason)], language)
    return EXIT_USAGE


def _is_nowhere() -> bool:
    """Return whether the working directory was removed."""
    try:
        Path.cwd()
    except FileNotFoundError:
        return True
    return False


def _never_fail_at_a_character() -> None:
    """Show a '?' for characters that the terminal's encoding lacks."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="replace")


def _trace_if_debugging(error: Exception) -> None:
    if os.environ.get("NCTAKT_DEBUG"):
        import traceback  # noqa: PLC0415 - only after an error

        traceback.print_exception(error)


def _internal_error(error: Exception) -> int:
    _trace_if_debugging(error)
    complain_notes(error)
    complain(f"internal error: {type(error).__name__}: {error}")
    complain(
        "  This is a fault of nctakt, not of your program. Set NCTAKT_DEBUG=1 and run the same "
        "command again for the traceback; please report it."
    )
    return EXIT_INTERNAL
