# SPDX-License-Identifier: MIT
"""The values of the HLI: one declaration of each, from which everything else is derived.

Structures of values, as a PLC sees them in memory (``hli/places.py`` gives each its bytes). Derived
from them are the table of the tick (``run/access/shared_image.py``), the C header
(``hli/header.py``) and the document ``docs/reference/hli.md``. ``PANEL`` are the operator's
commands and ``LAMPS`` the signals of the channel to the operator; each has a cell in the memory, in
this order (``kernel/plc/panel.py``). From outside they are called ``HLI.OVERRIDE``, ``HLI.STATE`` …
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.hli.table import Element, Tie, find
from nctakt.kernel import cells
from nctakt.kernel.plc.technology_slots import SLOT_COUNT

#: The prefix of the names of operator's values: ``HLI.FEED_HOLD``.
PREFIX = "HLI."

#: The first bytes of an image.
MAGIC = b"NCTAKT\0\0"

#: Version of the layout, changed whenever a value changes its offset or meaning.
VERSION = 9

#: Changes with each version, for connections to an older or newer partner.
DIFFERENCES = {
    7: Text(
        "7: functions have their synchronisation and value, and T is among them",
        "7: Funktionen haben Synchronisation und Wert, und T ist dabei",
    ),
    8: Text(
        "8: values that the controller has, too, have its names, types and units "
        "(active_feed_r, override_command_w …); mc_watchdog, error_serial",
        "8: Werte, die auch die Steuerung hat, tragen deren Namen, Typen und Einheiten "
        "(active_feed_r, override_command_w …); mc_watchdog, error_serial",
    ),
    9: Text(
        "9: block search (block_search_type_command_w …)",
        "9: Satzvorlauf (block_search_type_command_w …)",
    ),
}

#: Size of each type, of names as a whole, in bytes.
TYPE_BYTES = {
    "BOOLEAN": 1,
    "UNS08": 1,
    "UNS16": 2,
    "UNS32": 4,
    "SGN32": 4,
    "UNS64": 8,
    "REAL64": 8,
    "STRING": 1,
}


#: The elementary types of the controller, as variables lists name them.
_TYPES = {
    "BOOL": "BOOLEAN",
    "USINT": "UNS08",
    "UINT": "UNS16",
    "DINT": "SGN32",
    "UDINT": "UNS32",
    "LREAL": "REAL64",
}


@dataclass(frozen=True, slots=True)
class Entry:
    """A value of the HLI: name, type as in variables lists (and UNS64), unit, meaning.

    ``count``: elements of an array, 0 for a single value. ``source``: the variable of the channel
    or axis that it shows (``nc/vocabulary/variables/variable_table.py``); empty for a value of
    other origin. ``path``: that of the same value on the controller: then the image has its name,
    type and unit from the table of the interface, and ``name`` is the short form of the session;
    empty where the controller has none, and the value is nctakt's. ``is_signed``: a value written
    by the PLC that may be below 0.
    """

    name: str
    type: str
    unit: str
    meaning: str
    count: int = 0
    source: str = ""
    path: str = ""
    is_signed: bool = False

    @property
    def _element(self) -> Element | None:
        return find(self.path) if self.path else None

    @property
    def member(self) -> str:
        """Its name in the image."""
        last = self.path.rpartition(".")[2]
        if last in ("command_w", "enable_w", "alive_rw"):
            return f"{self.path.split('.')[-2]}_{last}"
        return last or self.name

    @property
    def image_type(self) -> str:
        """Its type in the image."""
        element = self._element
        return self.type if element is None else _TYPES[element.type.name]

    @property
    def image_unit(self) -> str:
        """Its unit in the image."""
        element = self._element
        return self.unit if element is None else element.unit

    @property
    def tie(self) -> Tie | None:
        """The relation of the controller's value to a run."""
        return None if self._element is None else self._element.tie

    @property
    def factor(self) -> float:
        """How many units of the image one of the session is."""
        tie = self.tie
        return 1.0 if tie is None or tie.kind == "fact" else float(tie.factor)


@dataclass(frozen=True, slots=True, eq=False)
class Structure:
    """A structure of values; ``units``: names of the arrays of ``UNIT`` after them.

    ``is_command``: the PLC writes it; the CNC writes all others. Equal only to itself, so that
    derived values can be cached.
    """

    name: str
    meaning: str
    entries: tuple[Entry, ...]
    units: tuple[str, ...] = ()
    is_command: bool = False


#: The operator's commands, written by the PLC.
PANEL = (
    Entry(
        "override",
        "REAL64",
        "%",
        "the operator's override of the path",
        path="gpCh[0]^.bahn_mc_control.override.command_w",
    ),
    Entry(
        "feed_hold",
        "BOOLEAN",
        "",
        "1: the path brakes to a standstill and stays there",
        path="gpCh[0]^.bahn_mc_control.feedhold.command_w",
    ),
    Entry(
        "single_block",
        "BOOLEAN",
        "",
        "1: the channel stops before each block",
        path="gpCh[0]^.bahn_mc_control.single_block.command_w",
    ),
    Entry(
        "start",
        "BOOLEAN",
        "",
        "START: the PLC writes 1, the CNC takes it and writes 0",
        path="gpCh[0]^.bahn_mc_control.continue_on.command_w",
    ),
    Entry(
        "reset",
        "BOOLEAN",
        "",
        "RESET: the PLC writes 1, the CNC takes it and writes 0",
        path="gpCh[0]^.channel_mc_control.reset.command_w",
    ),
    Entry(
        "plc_present",
        "BOOLEAN",
        "",
        "1: the PLC acknowledges functions, 0: the CNC itself",
        path="gpCh[0]^.head.plc_present_w",
    ),
    Entry(
        "backward_motion",
        "BOOLEAN",
        "",
        "1: the path is walked back, 0: forward again",
        path="gpCh[0]^.bahn_mc_control.backward_motion.command_w",
    ),
    Entry(
        "probe",
        "BOOLEAN",
        "",
        "1: the probe touches (G100), or is on the edge (G108)",
        path="gpCh[0]^.channel_mc_control.probe.command_w",
    ),
    Entry(
        "optional_stop",
        "BOOLEAN",
        "",
        "1: M01 stops as M00 does",
        path="gpCh[0]^.bahn_mc_control.m01_stop_enable.command_w",
    ),
    Entry(
        "watchdog",
        "BOOLEAN",
        "",
        "1: the PLC shows in time that it lives, or it is an error",
        path="gpCh[0]^.head.mc_watchdog.enable_w",
    ),
    Entry(
        "alive",
        "BOOLEAN",
        "",
        "the sign of life: the PLC writes 1, the CNC takes it, writes 0",
        path="gpCh[0]^.head.mc_watchdog.alive_rw",
    ),
    Entry(
        "search_type",
        "UNS16",
        "",
        "block search of each program that begins: 0 none, 4 to a block",
        path="gpCh[0]^.decoder_mc_control.block_search_type.command_w",
    ),
    Entry(
        "search_block",
        "UNS32",
        "",
        "N number of the block to which block search goes",
        path="gpCh[0]^.decoder_mc_control.block_search_number.command_w",
    ),
    Entry(
        "search_pass",
        "UNS32",
        "",
        "the pass over this block at which the program begins, from 1",
        path="gpCh[0]^.decoder_mc_control.block_search_pass.command_w",
    ),
)

#: The signals to the operator, written by the CNC.
LAMPS = (
    Entry("state", "UNS08", "", "0 ready, 1 a program runs, 2 error, 3 reset"),
    Entry(
        "paused",
        "BOOLEAN",
        "",
        "1: single block, M00 or M01 waits for START",
        path="gpCh[0]^.bahn_state.wait_continue_r",
    ),
    Entry("armed", "BOOLEAN", "", "1: a selected program waits for START"),
    Entry("error", "UNS32", "", "number of the error that has stopped the channel, else 0"),
    Entry(
        "retrace",
        "UNS08",
        "",
        "0: at its front, 1 backward over the history, 2 forward again",
        path="gpCh[0]^.bahn_state.retrace_r",
    ),
    Entry("history", "UNS32", "", "blocks in the history of the path, the current one included"),
    Entry(
        "inside_rt_loop",
        "BOOLEAN",
        "",
        "1: the path is in a realtime loop",
        path="gpCh[0]^.bahn_state.inside_rt_loop_r",
    ),
    Entry("history_size", "UNS32", "", "blocks that the history holds (P-STUP-00033); 0: none"),
    Entry("tool_time", "REAL64", "s", "that the tool has worked since it came"),
    Entry("tool_distance", "REAL64", "mm", "that the tool has worked since it came"),
    Entry("life_serial", "UNS32", "", "tool lives that were sent; another one: the values below"),
    Entry("life_tool", "UNS32", "", "the number of the tool whose life was sent last"),
    Entry("life_time", "REAL64", "s", "its time"),
    Entry("life_distance", "REAL64", "mm", "its distance"),
    Entry("error_serial", "UNS32", "", "how many errors have stopped the channel"),
)

#: Axis offsets and free values of a tool that the interface has.
TOOL_OFFSETS, TOOL_PARAMETERS = 6, 10

#: Requests of a channel to the tool manager of the PLC (P-CHAN-00016), written by the CNC.
TOOL_REQUEST = (
    Entry("tool_request", "UNS32", "", "number of the latest request; another one: a new request"),
    Entry("tool_request_kind", "UNS08", "", "1: the data of a tool (D), 2: T, to get it ready"),
    Entry("tool_request_basic", "UNS32", "", "number of the tool that is asked for"),
    Entry("tool_request_sister", "UNS32", "", "its sister number, 0 for none"),
    Entry("tool_request_variant", "UNS32", "", "its variant number, 0 for none"),
    Entry("tool_request_t", "UNS32", "", "the latest T"),
    Entry("tool_request_d", "UNS32", "", "the latest D: the tool that goes"),
    *(
        Entry(f"tool_request_parameter_{i}", "REAL64", "", f"P[{i}] of the tool that goes")
        for i in range(TOOL_PARAMETERS)
    ),
)

#: Answers of the tool manager, written by the PLC; the number last.
TOOL_ANSWER = (
    Entry("tool_manager", "BOOLEAN", "", "1: the PLC manages the tools, and is asked for them"),
    Entry("tool_answer", "UNS32", "", "number of the request that is answered"),
    Entry("tool_valid", "BOOLEAN", "", "1: there is such a tool"),
    Entry("tool_type", "UNS16", "", "0 milling, 1 turning, 2 grinding tool"),
    Entry("tool_cutter", "UNS16", "", "orientation of the cutter of a turning tool"),
    Entry("tool_spindle", "UNS16", "", "logical number of its spindle, 0 for none"),
    Entry("tool_kinematic", "UNS16", "", "ID of its kinematic, 0 for none"),
    Entry("tool_length", "REAL64", "mm", "its length", is_signed=True),
    Entry("tool_radius", "REAL64", "mm", "its radius"),
    Entry("tool_min_speed", "REAL64", "rev/min", "its least speed, 0 for none"),
    Entry("tool_max_speed", "REAL64", "rev/min", "its highest speed, 0 for none"),
    Entry("tool_max_acceleration", "REAL64", "°/s²", "of its spindle, 0 for that of the spindle"),
    *(
        Entry(f"tool_offset_{i}", "REAL64", "mm, °", f"its offset for axis {i}", is_signed=True)
        for i in range(TOOL_OFFSETS)
    ),
    *(
        Entry(f"tool_parameter_{i}", "REAL64", "", f"its P[{i}]", is_signed=True)
        for i in range(TOOL_PARAMETERS)
    ),
)

#: Both, as they are in the memory; the image of another process does not have them.
TOOLS = (*TOOL_REQUEST, *TOOL_ANSWER)

#: Cells of a channel's panel.
PANEL_CELLS = len(PANEL) + len(LAMPS) + len(TOOLS)

HEADER = Structure(
    "hli_header",
    "the start of the image: what it holds, where, and the clock",
    (
        Entry("magic", "STRING", "", "`NCTAKT` and two zero bytes", count=8),
        Entry("version", "UNS32", "", f"{VERSION}; another one is another layout"),
        Entry("ready", "UNS32", "", "1 while the CNC is there; written last, taken away first"),
        Entry("size", "UNS32", "bytes", "the whole image"),
        Entry("cycle_time_us", "UNS32", "µs", "the length of a tick"),
        Entry("channels", "UNS32", "", "number of `hli_channel` and of `hli_command`"),
        Entry("channel_offset", "UNS32", "bytes", "place of the first `hli_channel`"),
        Entry("channel_size", "UNS32", "bytes", "from one `hli_channel` to the next"),
        Entry("axes", "UNS32", "", "number of `hli_axis`"),
        Entry("axis_offset", "UNS32", "bytes", "place of the first `hli_axis`"),
        Entry("axis_size", "UNS32", "bytes", "from one `hli_axis` to the next"),
        Entry("spindles", "UNS32", "", "number of `hli_spindle` and of `hli_spindle_command`"),
        Entry("spindle_offset", "UNS32", "bytes", "place of the first `hli_spindle`"),
        Entry("spindle_size", "UNS32", "bytes", "from one `hli_spindle` to the next"),
        Entry("command_offset", "UNS32", "bytes", "place of the first `hli_command`"),
        Entry("command_size", "UNS32", "bytes", "from one `hli_command` to the next"),
        Entry("spindle_command_offset", "UNS32", "bytes", "of the first `hli_spindle_command`"),
        Entry("spindle_command_size", "UNS32", "bytes", "from one of them to the next"),
        Entry("link_offset", "UNS32", "bytes", "place of `hli_link`"),
        Entry("ve_offset", "UNS32", "bytes", "place of the V.E variables"),
        Entry("ve_size", "UNS32", "bytes", "of the V.E variables, all sections"),
        Entry("names_offset", "UNS32", "bytes", "place of the names of the V.E variables"),
        Entry("names_size", "UNS32", "bytes", "of these names, a text: docs/hli.md"),
        Entry("lockstep", "UNS32", "", "1: the CNC waits for the PLC after each tick"),
        Entry("sequence", "UNS64", "", "odd while the CNC writes; unchanged: what was read fits"),
        Entry("tick", "UNS64", "", "ticks that have been run"),
        Entry("turn", "UNS64", "", "in lockstep: counts the times that the CNC waits for the PLC"),
        Entry("process", "UNS64", "", "ID of the CNC's process, whose end the PLC can notice"),
    ),
)

UNIT = Structure(
    "hli_unit",
    "a slot for one M, H or T function",
    (
        Entry("serial", "UNS32", "", "0: free; else the running number of the function"),
        Entry("letter", "UNS32", "", "1 M, 2 H, 3 T"),
        Entry("number", "UNS32", "", "of the function: 100 for M100, the tool of T"),
        Entry("sequence", "UNS32", "", "its number among those of its tick and section, from 1"),
        Entry("axis", "UNS32", "", "`logical` of the axis or spindle that it is for, 0: channel"),
        Entry("value", "SGN32", "", "its value in the program, as in M110=130; 0 for none"),
        Entry("identifier", "UNS32", "", "1: the program's, 2 POS_RT: of a realtime cycle"),
        Entry(
            "synchronisation",
            "UNS32",
            "",
            "bits of its type, 1 MOS, 2 MVS_SVS … (P-CHAN-00041, P-CHAN-00027); POS_RT: always MOS",
        ),
        Entry("time_us", "UNS64", "µs", "the begin of the tick that has commanded it"),
        Entry("duration_us", "UNS64", "µs", "the time that the channel list gives it"),
    ),
)

CHANNEL = Structure(
    "hli_channel",
    "the state of a channel",
    (
        *LAMPS,
        Entry("override_total", "UNS32", "%", "that acts", source="OVERRIDE.VEL.TOTAL"),
        Entry(
            "path_speed",
            "REAL64",
            "mm/s",
            "the speed on the path",
            source="PATH.SPEED",
            path="gpCh[0]^.bahn_state.active_feed_r",
        ),
        Entry(
            "distance_to_go",
            "REAL64",
            "mm",
            "left of the block",
            source="PATH.DIST_TO_GO",
            path="gpCh[0]^.bahn_state.dist_to_go_r",
        ),
        Entry(
            "block",
            "UNS32",
            "",
            "N number of the current block",
            source="BLOCK",
            path="gpCh[0]^.bahn_state.block_number_r",
        ),
        Entry("active_cycles", "UNS32", "", "realtime cycles that run", source="CYCLES.ACTIVE"),
    ),
    units=("program", "realtime"),
)

AXIS = Structure(
    "hli_axis",
    "the state of an axis",
    (
        Entry("name", "STRING", "", "its name in the channel, with a zero byte", count=16),
        Entry("logical", "UNS32", "", "its logical number", path="gpAx[0]^.head.log_ax_n_r"),
        Entry(
            "command",
            "REAL64",
            "mm, °",
            "command position, ACS",
            source="ACS.ACT_POS",
            path="gpAx[0]^.lr_state.active_position_acs_r",
        ),
        Entry(
            "actual",
            "REAL64",
            "mm, °",
            "actual position, ACS",
            source="ACS.CUR_POS",
            path="gpAx[0]^.lr_state.current_position_acs_r",
        ),
        Entry(
            "target",
            "REAL64",
            "mm, °",
            "end of the motion, ACS",
            source="ACS.CMD_POS",
            path="gpAx[0]^.lr_state.end_position_acs_r",
        ),
        Entry("machine", "REAL64", "mm, °", "command position, MCS", source="MCS.ACT_POS"),
        Entry(
            "program",
            "REAL64",
            "mm, °",
            "command position, PCS",
            source="PCS.ACT_POS",
            path="gpCh[0]^.bahn_state.coord_r[0].act_position_r",
        ),
        Entry("distance_to_go", "REAL64", "mm, °", "left to the target", source="MCS.DIST_TO_GO"),
        Entry("override_total", "UNS32", "%", "of its own motions", source="OVERRIDE.VEL.TOTAL"),
        Entry(
            "state",
            "UNS08",
            "",
            "PLCopen: 1 Standstill, 2 DiscreteMotion, 3 ContinuousMotion, 4 Stopping, "
            "5 ErrorStop, 6 SynchronizedMotion",
            source="STATE",
        ),
    ),
)

SPINDLE = Structure(
    "hli_spindle",
    "the state of a spindle; where the PLC turns it, the job that waits for it",
    (
        Entry("name", "STRING", "", "its name in programs, with a zero byte", count=16),
        Entry("logical", "UNS32", "", "its logical number"),
        Entry("channel", "UNS32", "", "number of its channel, from 1"),
        Entry("plc_controlled", "UNS32", "", "1: the PLC turns it (P-CHAN-00069)"),
        Entry(
            "speed",
            "REAL64",
            "rev/min",
            "negative under M4; the CNC's only",
            source="SPEED",
            path="gpAx[0]^.lr_state.active_rev_r",
        ),
        Entry("position", "REAL64", "°", "0 … 360; of the CNC's only", source="POSITION"),
        Entry("job", "UNS32", "", "0: none waits; else the running number of the job"),
        Entry("function", "UNS32", "", "3, 4, 5 or 19: M3, M4, M5, M19"),
        Entry("direction", "UNS32", "", "of M19: 0 the shorter way, 1 forward, 2 back"),
        Entry("job_time_us", "UNS64", "µs", "the begin of the tick that has commanded it"),
        Entry("job_duration_us", "UNS64", "µs", "the time that the channel list gives it"),
        Entry("job_speed", "REAL64", "rev/min", "the speed that is commanded"),
        Entry("job_position", "REAL64", "°", "of M19"),
    ),
)

COMMAND = Structure(
    "hli_command",
    "what the PLC commands a channel",
    (
        *PANEL,
        Entry(
            "ack_program",
            "UNS32",
            "",
            "acknowledges `program[i]` of the channel: its serial",
            count=SLOT_COUNT,
        ),
        Entry(
            "ack_realtime",
            "UNS32",
            "",
            "acknowledges `realtime[i]` of the channel: its serial",
            count=SLOT_COUNT,
        ),
    ),
    is_command=True,
)

#: The operator's command of a spindle; its cell comes after the spindle's signals.
SPINDLE_OVERRIDE = Entry(
    "override",
    "REAL64",
    "%",
    "the operator's override of a spindle that the CNC turns",
    path="gpAx[0]^.ipo_mc_control.override.command_w",
)

SPINDLE_COMMAND = Structure(
    "hli_spindle_command",
    "what the PLC commands a spindle, and its answer for one that it turns",
    (
        Entry("ack_job", "UNS32", "", "acknowledges `job` of the spindle: its number"),
        Entry("reserved", "UNS32", "", "not used"),
        SPINDLE_OVERRIDE,
    ),
    is_command=True,
)

LINK = Structure(
    "hli_link",
    "the PLC's side of the lockstep",
    (
        Entry("turn", "UNS64", "", "`turn` of the header, as soon as the PLC has answered"),
        Entry("process", "UNS64", "", "ID of the PLC's process, whose end is noticed; 0: none"),
    ),
    is_command=True,
)

#: All structures in the order of the image; ``UNIT`` is a part of channels.
STRUCTURES = (HEADER, LINK, UNIT, CHANNEL, AXIS, SPINDLE, COMMAND, SPINDLE_COMMAND)


@dataclass(frozen=True, slots=True)
class PanelValue:
    """A value of the panel by its external name: its cell, and whether the PLC writes it."""

    name: str
    entry: Entry
    cell: int
    is_command: bool


def panel_values(first_cell: int) -> Iterator[PanelValue]:
    """Yield the operator's values of a channel whose panel begins at ``first_cell``."""
    for offset, entry in enumerate((*PANEL, *LAMPS, *TOOLS)):
        name = PREFIX + entry.name.upper()
        is_command = entry in PANEL or entry in TOOL_ANSWER
        yield PanelValue(name, entry, first_cell + offset, is_command)


def spindle_value_name(spindle: str) -> str:
    """Return the name from outside of the override of a spindle: ``HLI.S2.OVERRIDE``."""
    return f"{PREFIX}{spindle}.{SPINDLE_OVERRIDE.name}".upper()


def spindle_values(names: Sequence[str], first_cell: int) -> Iterator[PanelValue]:
    """Yield the operator's values of spindles whose cells begin at ``first_cell``."""
    for index, spindle in enumerate(names):
        cell = first_cell + cells.SPINDLE_CELLS * index + cells.SPINDLE_OVERRIDE
        yield PanelValue(spindle_value_name(spindle), SPINDLE_OVERRIDE, cell, True)
