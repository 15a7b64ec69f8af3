# SPDX-License-Identifier: MIT
"""Channel lists (P-CHAN): declarations of axes, spindles, programs and realtime cycles.

What they yield is in ``channel_configuration.py``; the tables of M and H functions are declared in
``technology_functions.py``.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.declared.coordinate_systems import COORDINATE_SYSTEMS
from nctakt.lists.declared.couplings import COUPLINGS
from nctakt.lists.declared.dynamic_weights import DYNAMIC_WEIGHTS
from nctakt.lists.declared.feed_groups import FEED_GROUPS
from nctakt.lists.declared.kinematics import KINEMATICS
from nctakt.lists.declared.measuring import CHANNEL_MEASURING
from nctakt.lists.declared.path_limits import PATH_LIMITS
from nctakt.lists.declared.single_block import SINGLE_BLOCK
from nctakt.lists.declared.spindle_gears import SPINDLE_GEARS
from nctakt.lists.declared.technology_functions import SPINDLE_FUNCTIONS, TECHNOLOGY, TOOL
from nctakt.lists.declared.tool_selection import CHANNEL_TOOLS
from nctakt.lists.format.parameter import MAX_UNS16, MAX_UNS32, Alias, Parameter, Value, ValueType
from nctakt.lists.format.reader import ListDialect
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.table import ParameterTable

MAX_AXES = 32
MAX_SPINDLES = 6
MAX_PATHS = 12
MAX_G_GROUPS = 40
MAX_G800 = 40
MAX_OVERRIDE = 2000
NAME_LENGTH = 16
_FILE_LENGTH = 83
_PATH_LENGTH = 256
_MAX_SGN16 = 2**15 - 1


def _channel(
    id_: str,
    path: str,
    type_: ValueType,
    default: Value,
    en: str,
    de: str,
    *,
    low: int | None = None,
    high: int | None = None,
    unit: str = "",
    restart: bool = False,
    aliases: tuple[Alias, ...] = (),
) -> Parameter:
    return Parameter(
        id_,
        path,
        type_,
        default,
        Text(en, de),
        low=low,
        high=high,
        unit=unit,
        restart=restart,
        aliases=aliases,
    )


_AXES = (
    _channel(
        "P-CHAN-00003",
        "gruppe[0..0].achs_anzahl",
        ValueType.UNS16,
        0,
        "Number of axes of the channel",
        "Anzahl der Achsen des Kanals",
        high=MAX_AXES,
    ),
    _channel(
        "P-CHAN-00035",
        f"gruppe[0..0].achse[0..{MAX_AXES - 1}].log_achs_nr",
        ValueType.UNS16,
        0,
        "Logical number of an axis of the channel",
        "Logische Nummer einer Achse des Kanals",
    ),
    _channel(
        "P-CHAN-00006",
        f"gruppe[0..0].achse[0..{MAX_AXES - 1}].bezeichnung",
        ValueType.STRING,
        "",
        "Name of an axis in NC programs",
        "Name einer Achse in NC-Programmen",
        high=NAME_LENGTH,
    ),
)

_SPINDLES = (
    _channel(
        "P-CHAN-00082",
        "spdl_anzahl",
        ValueType.UNS16,
        0,
        "Number of spindles of the channel",
        "Anzahl der Spindeln des Kanals",
        high=MAX_SPINDLES,
    ),
    _channel(
        "P-CHAN-00051",
        "main_spindle_ax_nr",
        ValueType.UNS16,
        0,
        "Logical number of the main spindle",
        "Logische Nummer der Hauptspindel",
    ),
    _channel(
        "P-CHAN-00053",
        "main_spindle_name",
        ValueType.STRING,
        "S",
        "Name of the main spindle in NC programs; begins with S",
        "Name der Hauptspindel in NC-Programmen; beginnt mit S",
        high=NAME_LENGTH,
    ),
    _channel(
        "P-CHAN-00010",
        "default_ax_name_of_spindle",
        ValueType.STRING,
        "",
        "Name of the axis that the main spindle is after #CAX without a name",
        "Name der Achse, die die Hauptspindel nach #CAX ohne Namen ist",
        high=NAME_LENGTH,
    ),
    _channel(
        "P-CHAN-00007",
        f"spindel[0..{MAX_SPINDLES - 1}].bezeichnung",
        ValueType.STRING,
        "",
        "Name of a spindle in NC programs; begins with S",
        "Name einer Spindel in NC-Programmen; beginnt mit S",
        high=NAME_LENGTH,
    ),
    _channel(
        "P-CHAN-00036",
        f"spindel[0..{MAX_SPINDLES - 1}].log_achs_nr",
        ValueType.UNS16,
        0,
        "Logical number of a spindle",
        "Logische Nummer einer Spindel",
    ),
    _channel(
        "P-CHAN-00069",
        f"spindel[0..{MAX_SPINDLES - 1}].plc_control",
        ValueType.BOOLEAN,
        False,
        "The PLC turns the spindle; no axis list is needed",
        "Die SPS dreht die Spindel; eine Achsliste ist nicht nötig",
    ),
)

_PROGRAMS = (
    _channel(
        "P-CHAN-00401",
        f"path[0..{MAX_PATHS - 1}].dir",
        ValueType.STRING,
        "",
        "Folder that is searched for NC programs",
        "Verzeichnis, in dem NC-Programme gesucht werden",
        high=_PATH_LENGTH,
    ),
    _channel(
        "P-CHAN-00403",
        f"path[0..{MAX_PATHS - 1}].type",
        ValueType.UNS16,
        0,
        "What the folder holds, as bits: 1 main, 2 subprograms, 4 message files, 8 debug data",
        "Inhalt des Verzeichnisses, als Bits: 1 Haupt-, 2 Unterprogramme, 4 Meldedateien, 8 Debug",
        high=15,
    ),
    _channel(
        "P-CHAN-00404",
        f"path[0..{MAX_PATHS - 1}].priority",
        ValueType.UNS16,
        0,
        "Order of the search, the lowest first",
        "Reihenfolge der Suche, die kleinste zuerst",
    ),
    _channel(
        "P-CHAN-00119",
        "start_init_prog_file",
        ValueType.STRING,
        "",
        "Subprogram that runs at program start",
        "Unterprogramm, das bei Programmstart läuft",
        high=_FILE_LENGTH,
    ),
    _channel(
        "P-CHAN-00252",
        "final_prog_file",
        ValueType.STRING,
        "",
        "Subprogram that runs at program end",
        "Unterprogramm, das bei Programmende läuft",
        high=_FILE_LENGTH,
    ),
    _channel(
        "P-CHAN-00118",
        "m6_prog_file",
        ValueType.STRING,
        "",
        "Subprogram that M6 calls",
        "Unterprogramm, das M6 ruft",
        high=_FILE_LENGTH,
    ),
    *(
        _channel(
            f"P-CHAN-{160 + index:05}",
            f"g{80 + index}_prog_file",
            ValueType.STRING,
            "",
            f"Subprogram that G{80 + index} calls",
            f"Unterprogramm, das G{80 + index} ruft",
            high=_FILE_LENGTH,
        )
        for index in range(10)
    ),
    _channel(
        "P-CHAN-00187",
        f"g800_prog_file[0..{MAX_G800 - 1}]",
        ValueType.STRING,
        "",
        "Subprogram that G800 and the following call",
        "Unterprogramm, das G800 und folgende rufen",
        high=_FILE_LENGTH,
    ),
)

_DEFAULTS = (
    _channel(
        "P-CHAN-00056",
        "max_vb_override",
        ValueType.UNS16,
        1000,
        "Highest override of the path",
        "Größter Override der Bahn",
        high=MAX_OVERRIDE,
        unit="0.1 %",
    ),
    _channel(
        "P-CHAN-00071",
        "prog_start.slope.profile",
        ValueType.SGN16,
        0,
        "Slope at program start: 0 trapezoid, 1 jerk-limited, 2 sine square, 3 HSC",
        "Slope bei Programmstart: 0 linear, 1 ruckbegrenzt, 2 Sinusquadrat, 3 HSC",
        low=0,
        high=3,
    ),
    _channel(
        "P-CHAN-00099",
        "prog_start.feedrate",
        ValueType.REAL64,
        0.0,
        "Feed until a program sets one",
        "Vorschub, bis ein Programm einen setzt",
        low=0,
        unit="mm/min",
    ),
    _channel(
        "P-CHAN-00108",
        "prog_start.feedrate_factor",
        ValueType.REAL64,
        100.0,
        "Unit of F: 100 mm/min, 0.1 m/min",
        "Einheit von F: 100 mm/min, 0.1 m/min",
    ),
    _channel(
        "P-CHAN-00063",
        f"prog_start.g_gruppe[0..{MAX_G_GROUPS - 1}].nr",
        ValueType.SGN16,
        -1,
        "G function of a group at program start; -1: the built-in one",
        "G-Funktion einer Gruppe bei Programmstart; -1: die eingebaute",
        low=-1,
        high=_MAX_SGN16,
    ),
    _channel(
        "P-CHAN-00235",
        "exact_stop_after_g00",
        ValueType.BOOLEAN,
        False,
        "Each rapid block ends with an exact stop",
        "Jeder Eilgangsatz endet mit einem Genauhalt",
    ),
    _channel(
        "P-CHAN-00273",
        "disable_chamfers_roundings",
        ValueType.BOOLEAN,
        False,
        "Chamfers and roundings (G301, G302, #CHR, #CHF, #RND) are errors",
        "Fasen und Rundungen (G301, G302, #CHR, #CHF, #RND) sind Fehler",
    ),
    _channel(
        "P-CHAN-00122",
        "hsc.bspline.path_deviation",
        ValueType.REAL64,
        2000.0,
        "Default of PATH_DEV of #HSC",
        "Voreinstellung von PATH_DEV bei #HSC",
        low=0,
        unit="0.1 µm",
    ),
    _channel(
        "P-CHAN-00125",
        "hsc.bspline.max_angle",
        ValueType.REAL64,
        0.0,
        "Default of MAX_ANGLE of #HSC",
        "Voreinstellung von MAX_ANGLE bei #HSC",
        low=0,
        unit="1e-4°",
    ),
    _channel(
        "P-CHAN-00059",
        "mittelpkt_diff",
        ValueType.REAL64,
        20_000.0,
        "How far the centre of an arc may be moved so that both ends lie on the circle",
        "Wie weit der Mittelpunkt eines Kreises verschoben werden darf, damit beide Enden auf dem "
        "Kreis liegen",
        low=0,
        unit="0.1 µm",
    ),
    _channel(
        "P-CHAN-00060",
        "mittelpkt_faktor",
        ValueType.UNS16,
        50,
        "How far the centre of an arc may be moved, as a share of the radius",
        "Wie weit der Mittelpunkt eines Kreises verschoben werden darf, als Anteil des Radius",
        low=1,
        high=MAX_UNS16 - 1,
        unit="‰",
    ),
    _channel(
        "P-CHAN-00219",
        "implicit_contour_masking",
        ValueType.BOOLEAN,
        False,
        "Damages of compensated contours farther apart than three blocks are errors",
        "Verletzungen korrigierter Konturen über mehr als drei Sätze sind Fehler",
    ),
    _channel(
        "P-CHAN-00030",
        "kasto_residual_path",
        ValueType.SGN32,
        0,
        "Edge banding: path that remains after the measuring signal",
        "Kantenanleimen: Weg, der nach dem Messsignal bleibt",
        low=0,
        unit="0.1 µm",
    ),
    _channel(
        "P-CHAN-00029",
        "kasto_multi_block",
        ValueType.BOOLEAN,
        False,
        "Edge banding across blocks",
        "Kantenanleimen über Sätze hinweg",
    ),
)


def _context(id_: str, name: str, en: str, de: str) -> Parameter:
    old = (Alias(f"twincat.context.{name}", silent=True),)
    path = f"schedule.context.{name}"
    return _channel(id_, path, ValueType.UNS32, 0, en, de, restart=True, aliases=old)


_REALTIME = (
    _channel(
        "P-CHAN-00406",
        "configuration.rt_cycles.enable",
        ValueType.BOOLEAN,
        False,
        "Realtime cycles are available",
        "Echtzeit-Zyklen sind verfügbar",
        restart=True,
        aliases=(Alias("rt_cycles.enable", silent=True),),
    ),
    _channel(
        "P-CHAN-00407",
        "configuration.rt_cycles.memory",
        ValueType.UNS32,
        48_000,
        "Memory for realtime cycles, all of it: the default is not added to the value, and what "
        "other functions of the channel have is not counted",
        "Speicher für Echtzeit-Zyklen, insgesamt: der Standardwert kommt nicht hinzu, und was "
        "andere Funktionen des Kanals haben, zählt nicht",
        high=MAX_UNS32 - 1,
        unit="byte",
        restart=True,
        aliases=(Alias("rt_cycles.memory", silent=True),),
    ),
    _channel(
        "P-CHAN-00480",
        "configuration.rt_cycles.buffers",
        ValueType.UNS16,
        5,
        "Motions and spindle jobs that one realtime cycle may have open at once",
        "Bewegungen und Spindelaufträge, die ein Echtzeit-Zyklus zugleich offen haben darf",
        high=MAX_UNS16 - 1,
        restart=True,
    ),
    _channel(
        "P-CHAN-00425",
        "rt_cycles.max_duration",
        ValueType.UNS16,
        75,
        "Share of the tick that all realtime cycles together may use",
        "Anteil am CNC-Takt, den alle Echtzeit-Zyklen zusammen nutzen dürfen",
        low=1,
        high=MAX_UNS16 - 1,
        unit="%",
    ),
    _channel(
        "P-CHAN-00426",
        "rt_cycles.cont_steps",
        ValueType.UNS32,
        100,
        "Elementary instructions between two checks of the time",
        "Elementar-Anweisungen zwischen zwei Prüfungen der Zeit",
        low=1,
        high=MAX_UNS32 - 1,
    ),
    _channel(
        "P-CHAN-00427",
        "rt_cycles.max_steps",
        ValueType.UNS32,
        MAX_UNS32 - 1,
        "Elementary instructions of all realtime cycles in one tick",
        "Elementar-Anweisungen aller Echtzeit-Zyklen in einem CNC-Takt",
        low=1,
        high=MAX_UNS32 - 1,
    ),
    _channel(
        "P-CHAN-00424",
        "configuration.decoder.v_ch_memory",
        ValueType.UNS32,
        0,
        "Memory for V.CH variables, their management included",
        "Speicher für V.CH-Variablen samt ihrer Verwaltung",
        high=MAX_UNS32 - 1,
        unit="byte",
        restart=True,
        aliases=(Alias("v_ch_memory"),),
    ),
    _context(
        "P-CHAN-00410",
        "geo",
        "Context of the thread that interpolates the channel",
        "Kontext des Threads, der den Kanal interpoliert",
    ),
    _context(
        "P-CHAN-00411",
        "sda",
        "Context of the thread that decodes the channel's programs",
        "Kontext des Threads, der die Programme des Kanals dekodiert",
    ),
    _context(
        "P-CHAN-00409",
        "com",
        "Context of the thread that communicates for the channel",
        "Kontext des Threads, der für den Kanal kommuniziert",
    ),
)

CHANNEL = Schema(
    "channel",
    Text("Channel list", "Kanalliste"),
    ListDialect(),
    _AXES
    + _SPINDLES
    + SPINDLE_FUNCTIONS
    + TECHNOLOGY
    + TOOL
    + _PROGRAMS
    + CHANNEL_TOOLS
    + KINEMATICS
    + PATH_LIMITS
    + FEED_GROUPS
    + COORDINATE_SYSTEMS
    + SPINDLE_GEARS
    + COUPLINGS
    + DYNAMIC_WEIGHTS
    + CHANNEL_MEASURING
    + SINGLE_BLOCK
    + _DEFAULTS
    + _REALTIME,
    ParameterTable("channel.tsv"),
)
