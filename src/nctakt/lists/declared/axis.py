# SPDX-License-Identifier: MIT
"""Axis lists (P-AXIS): declarations.

What they yield is in ``axis_configuration.py``. Units are those of the lists: positions 0.1 µm or
1e-4°, speeds µm/s or 1e-3°/s, accelerations mm/s² or °/s², ramp times µs. Lengths of linear and
angles of rotary axes share their parameters. Gear steps: ``getriebe[i]``.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.declared.couplings import AXIS_GANTRY
from nctakt.lists.declared.feed_forward import FEED_FORWARD
from nctakt.lists.declared.homing import AXIS_HOMING
from nctakt.lists.declared.measuring import AXIS_MEASURING
from nctakt.lists.format.parameter import Limit, Parameter, Value, ValueType
from nctakt.lists.format.reader import ListDialect
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.table import ParameterTable

GEAR_STEPS = 6
MAX_OVERRIDE = 2000
_MAX_SGN32 = 2**31 - 1
_FASTEST = 2_000_000_000
_STEEPEST = 100_000_000
_SPEED = "µm/s, 1e-3°/s"
_ACCELERATION = "mm/s², °/s²"
_POSITION = "0.1 µm, 1e-4°"

_MAX_SPEED = Limit("P-AXIS-00212")
_MAX_ACCELERATION = Limit("P-AXIS-00008")
_SHORTEST_RAMP = Limit("P-AXIS-00201")

LINEAR_TYPE, ROTARY_TYPE, SPINDLE_TYPE = "ACHSTYP_TRANSLATOR", "ACHSTYP_ROTATOR", "ACHSTYP_SPINDEL"


def _axis(
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
    at_least: Limit | None = None,
    at_most: Limit | None = None,
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
        at_least=at_least,
        at_most=at_most,
    )


def _gear(
    id_: str,
    path: str,
    default: int,
    en: str,
    de: str,
    *,
    low: int = 0,
    high: int | None = None,
    unit: str,
    at_least: Limit | None = None,
    at_most: Limit | None = None,
) -> Parameter:
    return _axis(
        id_,
        f"getriebe[0..{GEAR_STEPS - 1}].{path}",
        ValueType.UNS32,
        default,
        en,
        de,
        low=low,
        high=high,
        unit=unit,
        at_least=at_least,
        at_most=at_most,
    )


def _speed(id_: str, path: str, default: int, en: str, de: str) -> Parameter:
    """Return the declaration of a speed, bounded by the maximum of the axis."""
    maximum = None if id_ == _MAX_SPEED.id else _MAX_SPEED
    return _gear(id_, path, default, en, de, low=1, high=_FASTEST, unit=_SPEED, at_most=maximum)


def _acceleration(id_: str, path: str, default: int, en: str, de: str) -> Parameter:
    """Return the declaration of an acceleration, bounded by the maximum of the axis."""
    maximum = None if id_ == _MAX_ACCELERATION.id else _MAX_ACCELERATION
    return _gear(
        id_, path, default, en, de, low=1, high=_STEEPEST, unit=_ACCELERATION, at_most=maximum
    )


def _ramp(id_: str, path: str, default: int, en: str, de: str) -> Parameter:
    """Return the declaration of a ramp time, bounded by the minimum of the axis."""
    minimum = None if id_ == _SHORTEST_RAMP.id else _SHORTEST_RAMP
    return _gear(id_, path, default, en, de, unit="µs", at_least=minimum)


_HEADER = (
    _axis(
        "P-AXIS-00016",
        "kopf.achs_nr",
        ValueType.UNS16,
        0,
        "Logical axis number, unique in the controller; 0: the defaults list",
        "Logische Achsnummer, in der Steuerung eindeutig; 0: die Liste der Standardwerte",
    ),
    _axis(
        "P-AXIS-00297",
        "kopf.log_achs_name",
        ValueType.STRING,
        "",
        "Name of the axis in messages",
        "Name der Achse in Meldungen",
        high=16,
    ),
)

_CHARACTER = (
    Parameter(
        "P-AXIS-00018",
        "kenngr.achs_typ",
        ValueType.NAME,
        LINEAR_TYPE,
        Text(
            "Kind of axis: 1 linear, 2 rotary, 4 spindle",
            "Art der Achse: 1 Linearachse, 2 Rundachse, 4 Spindel",
        ),
        names={LINEAR_TYPE: 1, ROTARY_TYPE: 2, SPINDLE_TYPE: 4},
        restart=True,
    ),
    _axis(
        "P-AXIS-00015",
        "kenngr.achs_mode",
        ValueType.UNS32,
        1,
        "Modes as bits: 1 linear, 4 modulo, 0x40 face axis, 0x200 C axis, 0x400 modulo linear",
        "Als Bits: 1 linear, 4 Modulo, 0x40 Planachse, 0x200 C-Achse, 0x400 Modulo, Linearachse",
    ),
    _axis(
        "P-AXIS-00586",
        "vib_guard.type",
        ValueType.UNS32,
        0,
        "Kind of FIR filter; #FILTER ON is refused unless it is 0",
        "Art des FIR-Filters; außer bei 0 ist #FILTER ON nicht möglich",
    ),
    _axis(
        "P-AXIS-00058",
        "kenngr.durchm_prog_abs",
        ValueType.BOOLEAN,
        False,
        "Under G51 absolute positions of the face axis (G90) are diameters",
        "Mit G51 sind absolute Positionen der Planachse (G90) Durchmesser",
    ),
    _axis(
        "P-AXIS-00059",
        "kenngr.durchm_prog_rel",
        ValueType.BOOLEAN,
        False,
        "Under G51 relative ways of the face axis (G91) are diameters",
        "Mit G51 sind relative Wege der Planachse (G91) Durchmesser",
    ),
    _axis(
        "P-AXIS-00457",
        "kenngr.enable_single_axis",
        ValueType.BOOLEAN,
        False,
        "The axis may be moved on its own, beside the path",
        "Die Achse darf für sich, neben der Bahn, bewegt werden",
    ),
    _axis(
        "P-AXIS-00474",
        "kenngr.check_spindle_speed_in_tool_range",
        ValueType.BOOLEAN,
        False,
        "A speed outside of the tool's range is an error, instead of being limited",
        "Eine Drehzahl außerhalb des Werkzeugbereichs ist ein Fehler, statt begrenzt zu werden",
    ),
    _axis(
        "P-AXIS-00491",
        "kenngr.indp_override_mode",
        ValueType.UNS16,
        0,
        "Override of independent motions: 0 channel, 1 the lesser of both, 2 axis",
        "Override unabhängiger Bewegungen: 0 Kanal, 1 der kleinere von beiden, 2 Achse",
        high=2,
    ),
    _axis(
        "P-AXIS-00177",
        "kenngr.swe_neg",
        ValueType.SGN32,
        -100_000_000,
        "Software limit in negative direction",
        "Softwareendschalter in negativer Richtung",
        unit=_POSITION,
    ),
    _axis(
        "P-AXIS-00178",
        "kenngr.swe_pos",
        ValueType.SGN32,
        100_000_000,
        "Software limit in positive direction",
        "Softwareendschalter in positiver Richtung",
        unit=_POSITION,
    ),
    _axis(
        "P-AXIS-00179",
        "kenngr.swe_toleranz",
        ValueType.UNS32,
        1000,
        "Widens the software limits for the place where the axis stands; commands keep them",
        "Erweitert die Softwareendschalter für den Ort, an dem die Achse steht; Befehle halten "
        "sie ein",
        unit=_POSITION,
    ),
    _axis(
        "P-AXIS-00109",
        "kenngr.max_vb_override",
        ValueType.UNS16,
        1000,
        "Highest override of independent motions and of spindles",
        "Größter Override unabhängiger Bewegungen und von Spindeln",
        low=1,
        high=MAX_OVERRIDE,
        unit="0.1 %",
    ),
    _axis(
        "P-AXIS-00079",
        "kenngr.getriebe_stufe",
        ValueType.UNS16,
        1,
        "Number of the gear step that is active after start-up",
        "Nummer der Getriebestufe, die nach dem Hochlauf aktiv ist",
        low=1,
    ),
    _axis(
        "P-AXIS-00276",
        "lr_param.field_bus_allows_optimized_schedule",
        ValueType.BOOLEAN,
        False,
        "The drives allow output without a delay of one cycle (schedule COMPLETE)",
        "Die Antriebe erlauben die Ausgabe ohne einen Takt Verzug (schedule COMPLETE)",
    ),
    _axis(
        "P-AXIS-00096",
        "antr.simu.ist_gleich_soll",
        ValueType.BOOLEAN,
        False,
        "The simulated drive follows exactly: actual position = command position",
        "Der simulierte Antrieb folgt genau: Istposition = Sollposition",
    ),
    _axis(
        "",
        "antr.simu.fixed_stop",
        ValueType.SGN32,
        0,
        "Place of an obstacle in the simulation that the axis cannot pass, seen from 0; 0: none",
        "Ort eines Hindernisses der Simulation, das die Achse nicht passiert, von 0 aus; 0: keines",
        unit="0.1 µm, 1e-4°",
    ),
)

_GEAR_STEP = (
    Parameter(
        "P-AXIS-00135",
        f"getriebe[0..{GEAR_STEPS - 1}].nummer",
        ValueType.UNS16,
        0,
        Text(
            "Number of the gear step; the first one has 1 if it names none",
            "Nummer der Getriebestufe; die erste hat 1, wenn sie keine nennt",
        ),
    ),
    _speed(
        "P-AXIS-00212",
        "dynamik.vb_max",
        200_000,
        "Highest speed of the axis",
        "Höchste Geschwindigkeit der Achse",
    ),
    _acceleration(
        "P-AXIS-00008",
        "dynamik.a_max",
        1000,
        "Highest acceleration of the axis",
        "Höchste Beschleunigung der Achse",
    ),
    _ramp(
        "P-AXIS-00201",
        "dynamik.tr_min",
        10_000,
        "Shortest ramp time of the acceleration",
        "Kürzeste Rampenzeit der Beschleunigung",
    ),
    _speed("P-AXIS-00209", "vb_eilgang", 166_666, "Rapid speed", "Eilganggeschwindigkeit"),
    _gear(
        "P-AXIS-00099",
        "kv",
        1000,
        "Gain of the position control",
        "Verstärkung der Lageregelung",
        low=1,
        unit="0.01/s",
    ),
    _axis(
        "P-AXIS-00078",
        f"getriebe[0..{GEAR_STEPS - 1}].getr_schalt_pos",
        ValueType.SGN32,
        0,
        "Where the spindle stands while this gear step is left",
        "Wo die Spindel steht, während diese Getriebestufe verlassen wird",
        unit=_POSITION,
        at_least=Limit("P-AXIS-00177", is_exclusive=True),
        at_most=Limit("P-AXIS-00178", is_exclusive=True),
    ),
    _axis(
        "P-AXIS-00126",
        f"getriebe[0..{GEAR_STEPS - 1}].moduloo",
        ValueType.SGN32,
        3_600_000,
        "Upper end of the modulo range",
        "Obere Grenze des Modulobereichs",
        unit=_POSITION,
    ),
    _axis(
        "P-AXIS-00127",
        f"getriebe[0..{GEAR_STEPS - 1}].modulou",
        ValueType.SGN32,
        0,
        "Lower end of the modulo range",
        "Untere Grenze des Modulobereichs",
        unit=_POSITION,
    ),
)

_RAMPS = (
    _acceleration(
        "P-AXIS-00001",
        "slope_profil.a_beschl",
        1000,
        "Acceleration at feed, jerk-limited slope",
        "Beschleunigung bei Vorschub, ruckbegrenzter Slope",
    ),
    _acceleration(
        "P-AXIS-00002",
        "slope_profil.a_brems",
        1000,
        "Deceleration at feed, jerk-limited slope",
        "Verzögerung bei Vorschub, ruckbegrenzter Slope",
    ),
    _acceleration(
        "P-AXIS-00004",
        "slope_profil.a_grenz",
        1000,
        "Acceleration and deceleration at rapid, jerk-limited slope",
        "Beschleunigung und Verzögerung im Eilgang, ruckbegrenzter Slope",
    ),
    _ramp(
        "P-AXIS-00196",
        "slope_profil.tr_beschl_zu",
        50_000,
        "Ramp time while the acceleration builds up",
        "Rampenzeit, während die Beschleunigung zunimmt",
    ),
    _ramp(
        "P-AXIS-00195",
        "slope_profil.tr_beschl_ab",
        50_000,
        "Ramp time while the acceleration fades",
        "Rampenzeit, während die Beschleunigung abnimmt",
    ),
    _ramp(
        "P-AXIS-00198",
        "slope_profil.tr_brems_zu",
        50_000,
        "Ramp time while the deceleration builds up",
        "Rampenzeit, während die Verzögerung zunimmt",
    ),
    _ramp(
        "P-AXIS-00197",
        "slope_profil.tr_brems_ab",
        50_000,
        "Ramp time while the deceleration fades",
        "Rampenzeit, während die Verzögerung abnimmt",
    ),
    _ramp(
        "P-AXIS-00200",
        "slope_profil.tr_grenz",
        10_000,
        "Ramp time at rapid",
        "Rampenzeit im Eilgang",
    ),
    _acceleration(
        "P-AXIS-00011",
        "lslope_profil.a_stufe_1",
        1000,
        "Acceleration at feed below the changeover speed, trapezoid slope",
        "Beschleunigung bei Vorschub unter der Umschaltgeschwindigkeit, linearer Slope",
    ),
    _acceleration(
        "P-AXIS-00012",
        "lslope_profil.a_stufe_2",
        1000,
        "Acceleration at feed above the changeover speed, trapezoid slope",
        "Beschleunigung bei Vorschub über der Umschaltgeschwindigkeit, linearer Slope",
    ),
    _speed(
        "P-AXIS-00221",
        "lslope_profil.vb_stufe_1_2",
        100_000,
        "Changeover speed at feed, trapezoid slope",
        "Umschaltgeschwindigkeit bei Vorschub, linearer Slope",
    ),
    _acceleration(
        "P-AXIS-00005",
        "lslope_profil.a_grenz_stufe_1",
        1000,
        "Acceleration at rapid below the changeover speed, trapezoid slope",
        "Beschleunigung im Eilgang unter der Umschaltgeschwindigkeit, linearer Slope",
    ),
    _acceleration(
        "P-AXIS-00006",
        "lslope_profil.a_grenz_stufe_2",
        1000,
        "Acceleration at rapid above the changeover speed, trapezoid slope",
        "Beschleunigung im Eilgang über der Umschaltgeschwindigkeit, linearer Slope",
    ),
    _speed(
        "P-AXIS-00211",
        "lslope_profil.vb_grenz_stufe_1_2",
        100_000,
        "Changeover speed at rapid, trapezoid slope",
        "Umschaltgeschwindigkeit im Eilgang, linearer Slope",
    ),
)

AXIS = Schema(
    "axis",
    Text("Axis list", "Achsliste"),
    ListDialect(),
    _HEADER
    + _CHARACTER
    + AXIS_MEASURING
    + AXIS_GANTRY
    + FEED_FORWARD
    + AXIS_HOMING
    + _GEAR_STEP
    + _RAMPS,
    ParameterTable("axis.tsv"),
)
