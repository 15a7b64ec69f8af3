# SPDX-License-Identifier: MIT
"""The recipes of ``CONTRIBUTING.md``, each as an example of the change that it describes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Edit:
    """A change of one file: ``text`` comes before ``anchor``, the only one in the file.

    Without an anchor the file is new. ``replaces``: the anchor goes.
    """

    path: str
    text: str
    anchor: str = ""
    replaces: bool = False

    def apply(self, root: Path) -> None:
        """Change the file below ``root``; fails where the file is no longer as described."""
        path = root / self.path
        if not self.anchor:
            assert not path.exists(), path
            path.write_text(self.text, "utf-8")
            return
        before = path.read_text("utf-8")
        assert before.count(self.anchor) == 1, f"{self.path}: {self.anchor!r}"
        after = self.text if self.replaces else self.text + self.anchor
        path.write_text(before.replace(self.anchor, after), "utf-8")


@dataclass(frozen=True)
class Recipe:
    """An example of a change.

    ``heading``: how ``CONTRIBUTING.md`` calls it, with the number of files. ``tests``: those that
    the recipe names, of the files that have many only what the example concerns. ``scripts``: what
    it runs afterwards.
    """

    heading: str
    edits: tuple[Edit, ...]
    tests: tuple[str, ...]
    scripts: tuple[str, ...] = ()

    @property
    def files(self) -> int:
        """The number of files that it touches."""
        return len({edit.path for edit in self.edits})


REFUSED_WORD = Recipe(
    "A word or G function that is known and refused: 1 file",
    (
        Edit(
            "src/nctakt/nc/vocabulary/functions.py",
            '        refused(118, "an example", "ein Beispiel"),\n',
            '        accepted(117, "look-ahead on", "Look-ahead ein"),\n',
        ),
    ),
    ("tests/nc/test_three_answers.py::test_a_refused_g_function_is_refused_by_name[G118]",),
)

VARIABLE = Recipe(
    "A V variable: 4 files",
    (
        Edit(
            "src/nctakt/nc/vocabulary/variables/realtime_variables.py",
            "    RealtimeVariable(\n"
            '        "PATH.WAITING",\n'
            '        "UNS32",\n'
            '        "",\n'
            "        Access.READ,\n"
            "        Access.READ,\n"
            '        Text("Segments that wait", "Segmente, die warten"),\n'
            "    ),\n",
            '    RealtimeVariable(\n        "TIMER",\n',
        ),
        Edit("src/nctakt/kernel/cells.py", "    CHANNEL_PATH_WAITING,\n", "    CHANNEL_TIMER,\n"),
        Edit("src/nctakt/kernel/cells.py", ") = range(16)", ") = range(15)", replaces=True),
        Edit(
            "src/nctakt/kernel/tick/channel.py",
            "        self.cells[self.first_cell + cells.CHANNEL_PATH_WAITING] = 7.0\n",
            "        self.cells[self.first_cell + cells.CHANNEL_PATH_DIST_TO_GO] = ",
        ),
        Edit(
            "tests/kernel/test_published_cells.py",
            '        "PATH.WAITING": 7.0,\n',
            '        "PATH.RAPID": 0.0,\n',
        ),
    ),
    ("tests/kernel/test_published_cells.py", "tests/kernel/test_cells.py"),
    ("scripts/constants",),
)

MESSAGE = Recipe(
    "A message: 3 files",
    (
        Edit(
            "src/nctakt/messages/programs/checked_blocks.py",
            "LONG_DWELL = note(\n"
            "    909999,\n"
            '    en="a dwell of {time} s is very long",\n'
            '    de="eine Verweilzeit von {time} s ist sehr lang",\n'
            '    remedy_en="Shorten it.",\n'
            '    remedy_de="Sie kürzen.",\n'
            '    time=("the dwell", "die Verweilzeit"),\n'
            ")\n\n",
            "G04_WITH_TWO_TIMES = ",
        ),
        Edit(
            "src/nctakt/nc/check/path/dwells.py", "    LONG_DWELL,\n", ")\nfrom nctakt.nc.check.exp"
        ),
        Edit(
            "src/nctakt/nc/check/path/dwells.py",
            "        if isinstance(time, Number) and time.value > 86400.0:\n"
            '            findings.report(LONG_DWELL, dwell.span, time=f"{time.value:g}")\n',
            "        values.value(time)\n",
        ),
        Edit(
            "tests/nc/check_words.nc",
            'G04 X90000 ; note 909999 "very long"\n',
            "#MAIN SPINDLE [S2]\n",
        ),
    ),
    ("tests/nc/test_check_chunks.py", "tests/messages/test_catalogue.py"),
)

CHANNEL_PARAMETER = Recipe(
    "A channel parameter: 4 files",
    (
        Edit(
            "src/nctakt/lists/declared/channel.tsv",
            "P-CHAN-09999\texample_limit\tREAL64\t5\t0 …\t\tmm\t\tused\t\t\t"
            "An example\tEin Beispiel\n",
            "P-CHAN-00005\t",
        ),
        Edit(
            "src/nctakt/lists/machine/channel_configuration.py",
            "    lead_blocks: int\n    example_limit_mm: float\n",
            "    lead_blocks: int\n",
            replaces=True,
        ),
        Edit(
            "src/nctakt/lists/machine/channel_configuration.py",
            '        values.real("example_limit"),\n    )\n\n\ndef _realtime_cycles',
            "    )\n\n\ndef _realtime_cycles",
            replaces=True,
        ),
        Edit(
            "src/nctakt/decoder/blocks/edge_banding.py",
            "    residual += 0.0 * values.environment.parameters.example_limit_mm\n",
            "    function, ticks, value = output.function",
        ),
        Edit(
            "tests/decoder/test_example_limit.py",
            "from support.changed_lists import machine_with\n\n"
            "from nctakt.lists.machine.machine import load_machine\n\n\n"
            "def test_it(tmp_path):\n"
            '    folder = machine_with(tmp_path / "lists", sda_mds1="example_limit 7")\n'
            "    machine = load_machine(folder)\n"
            "    assert machine.channels[0].parameters.example_limit_mm == 7.0\n",
        ),
    ),
    ("tests/lists/test_effects.py", "tests/decoder/test_example_limit.py"),
)

SUBCOMMAND = Recipe(
    "A subcommand: 4 files",
    (
        Edit(
            "src/nctakt/cli/example.py",
            '"""The subcommand ``nctakt example``."""\n\n'
            "from nctakt.base.diagnostics import Text\n"
            "from nctakt.cli.common.help import described\n\n\n"
            '@described("example", summary=Text("Do nothing.", "Nichts tun."), '
            'text=Text("Do nothing.", "Nichts tun."))\n'
            "def command() -> int:\n"
            '    """Do nothing."""\n'
            "    return 0\n",
        ),
        Edit(
            "src/nctakt/cli/__init__.py",
            '        "example": "nctakt.cli.example",\n',
            '        "schedule": "nctakt.cli.schedule",\n',
        ),
        Edit(
            "tests/cli/test_example_command.py",
            'from nctakt.cli import main\n\n\ndef test_it():\n    assert main(["example"]) == 0\n',
        ),
        Edit("README.md", "| `nctakt example` | does nothing |\n", "| `nctakt schedule` |"),
    ),
    (
        "tests/cli/test_example_command.py",
        "tests/cli/test_every_command.py::test_each_command_has_a_short_help_option_and_tells_its_exit_codes[example]",
    ),
)

RUN_OPTION = Recipe(
    "A run option: 3 files",
    (
        Edit(
            "src/nctakt/run/options.py",
            "    example: int | None\n",
            "    from_line: int | None\n    from_block",
        ),
        Edit(
            "src/nctakt/run/options.py",
            "    RunOption(\n"
            '        name="example",\n'
            "        kind=Whole(),\n"
            '        help=Text("Run N ticks more.", "N Takte länger laufen."),\n'
            '        accepted_by=f"{_RUNS} {_SESSIONS} study {_DATA} comment tape",\n'
            "    ),\n",
            '    RunOption(\n        name="plc",\n',
        ),
        Edit(
            "src/nctakt/run/program_run.py",
            '            limits = [one + (self._options["example"] or 0) for one in limits]\n',
            '        if self._options["stays"] and not limits:\n',
        ),
        Edit(
            "src/nctakt/run/program_run.py",
            "        if limits:\n",
            '            limits = [one + (self._options["example"]',
        ),
        Edit("tests/test_run_options.py", '    "example": (["9"], 9, 9),\n', '    "from_line": (['),
        Edit(
            "tests/test_run_options.py",
            "def test_it():\n"
            "    run = Controller().run(NcText('p.nc', 'G04 1\\nM30'), ticks=5, example=2)\n"
            "    assert run.ticks == 7\n\n\n",
            "def test_a_tape()",
        ),
    ),
    ("tests/test_run_options.py",),
)

G_FUNCTION = Recipe(
    "A G function of the decoder: 4 files",
    (
        Edit(
            "src/nctakt/nc/vocabulary/functions.py",
            '        simulated(119, "an example", "ein Beispiel"),\n',
            '        plain(ABSOLUTE, "absolute dimensions"',
        ),
        Edit(
            "src/nctakt/decoder/blocks/modal_functions.py",
            "        self._state.absolute = function in (ABSOLUTE, 119)\n",
            "        self._state.absolute = function == ABSOLUTE\n",
            replaces=True,
        ),
        Edit(
            "tests/nc/check_words.nc",
            'G90 G119 ; error 900210 "G119"\n',
            "#MAIN SPINDLE [S2]\n",
        ),
        Edit(
            "tests/decoder/test_example_function.py",
            "from support.decided import perform\n\n\n"
            "def test_it():\n"
            '    run = perform("G91 G00 X10\\nG119 X10\\nM30")\n'
            '    assert run.trace["X.ACS.ACT_POS"][-1] == 10.0\n',
        ),
    ),
    ("tests/nc/test_check_chunks.py", "tests/decoder/test_example_function.py"),
)

HASH_COMMAND = Recipe(
    "A `#` command of the decoder: 3 files",
    (
        Edit(
            "src/nctakt/nc/vocabulary/commands.tsv",
            "#EXAMPLE\tsimulated\t\t#EXAMPLE\tan example\tein Beispiel\n",
            "#EXPL SYN\tsimulated",
        ),
        Edit(
            "src/nctakt/decoder/flow/hash_commands.py",
            '            "#EXAMPLE": self._example,\n',
            '            "#FACE": ',
        ),
        Edit(
            "src/nctakt/decoder/flow/hash_commands.py",
            "    def _example(self, _command: tree.HashCommand, _: int) -> Iterable[Command]:\n"
            "        self._values.state.absolute = False\n"
            "        return ()\n\n",
            "    def _orient_tool(",
        ),
        Edit(
            "tests/decoder/test_example_command.py",
            "from support.decided import perform\n\n\n"
            "def test_it():\n"
            '    run = perform("G90 G00 X10\\n#EXAMPLE\\nX10\\nM30")\n'
            '    assert run.trace["X.ACS.ACT_POS"][-1] == 20.0\n',
        ),
    ),
    (
        "tests/nc/test_three_answers.py::test_a_command_whose_name_is_its_only_form_has_no_arguments"
        "[#EXAMPLE]",
        "tests/nc/test_support.py",
        "tests/decoder/test_example_command.py",
    ),
)

QUEUE_COMMAND = Recipe(
    "A command of the queue: 5 files",
    (
        Edit(
            "src/nctakt/kernel/rows.py",
            "(\n"
            "    EXAMPLE,  # an example\n"
            "    EXAMPLE_AXIS,\n"
            "    EXAMPLE_VALUE,\n"
            ") = _command(HOLDS_AXIS, HOLDS_NUMBER, transparent=True)\n",
            "\n#: The kinds that take or may take time.\n",
        ),
        Edit(
            "src/nctakt/decoder/state/queued/commands.py",
            "@dataclass(frozen=True, slots=True)\n"
            "class Example(Command):\n"
            '    """An example."""\n\n'
            "    packed_as = rows.EXAMPLE\n\n"
            "    axis: int\n"
            "    value: float\n\n\n",
            "@dataclass(frozen=True, slots=True)\nclass EmptyBlock(",
        ),
        Edit("src/nctakt/decoder/flow/hash_commands.py", "    Example,\n", "    Flush,\n    Pos"),
        Edit(
            "src/nctakt/decoder/flow/hash_commands.py",
            "        yield Example(self._environment.source_id(command.span), number, 1, 7.0)\n\n",
            "    def _take_positions(",
        ),
        Edit(
            "src/nctakt/kernel/tick/command_execution.py",
            "        elif kind == rows.EXAMPLE:\n"
            "            count = self.first_cell + cells.CHANNEL_LOOP_COUNT\n"
            "            self.cells[count] = self.queue.rows[row + rows.EXAMPLE_VALUE]\n",
            "        elif kind == rows.LOOP_BEGIN:\n",
        ),
        Edit(
            "tests/decisions/test_example_in_queue.py",
            "from support.decided import left\n\n\n"
            "def test_it():\n"
            '    program = "G01 X10 F6000\\n#BACKWARD STORAGE CLEAR\\nX20\\nM30"\n'
            '    assert left(program, "V.RTG.LOOP.COUNT") == 7\n',
        ),
    ),
    (
        "tests/decoder/test_packing.py",
        "tests/kernel/test_entrances.py",
        "tests/decisions/test_example_in_queue.py",
    ),
    ("scripts/constants",),
)

SHOWN_ELEMENT = Recipe(
    "A value that the interface shows: 2 files",
    (
        Edit(
            "src/nctakt/hli/elements/interface.tsv",
            "gpCh[]^.bahn_state.example_r\tUDINT\tCNC\t\t\t\tours\tshows BLOCK\t"
            "An example\tEin Beispiel\n",
            "gpCh[]^.bahn_state.block_number_r\t",
        ),
        Edit(
            "tests/plc/test_example_element.py",
            "from nctakt import Controller, NcText\n\n\n"
            "def test_it():\n"
            "    seen = set()\n\n"
            "    class Plc:\n"
            "        def cycle(self, hli):\n"
            '            seen.add(hli["gpCh[0]^.bahn_state.example_r"])\n\n'
            "    Controller().run(NcText('p.nc', 'N70 G01 X10 F600\\nM30'), plc=Plc())\n"
            "    assert 70 in seen\n",
        ),
    ),
    ("tests/plc/test_example_element.py", "tests/hli/test_table.py"),
)

RECIPES = (
    REFUSED_WORD,
    G_FUNCTION,
    HASH_COMMAND,
    VARIABLE,
    QUEUE_COMMAND,
    SHOWN_ELEMENT,
    MESSAGE,
    CHANNEL_PARAMETER,
    SUBCOMMAND,
    RUN_OPTION,
)
