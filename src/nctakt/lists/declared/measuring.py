# SPDX-License-Identifier: MIT
"""Axis lists (P-AXIS) and channel lists (P-CHAN): measuring with a touch probe (G100)."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Limit, Parameter, ValueType

_POSITION = "0.1 µm, 1e-4°"
#: How a simulated probe may give its signal (P-AXIS-00112).
SIMULATIONS = range(1, 7)
#: Measuring types (P-CHAN-00057).
FIRST_TYPE, LAST_TYPE = 1, 7

AXIS_MEASURING = (
    Parameter(
        "P-AXIS-00330",
        "kenngr.meas_signal_fixed_stop",
        ValueType.BOOLEAN,
        False,
        Text(
            "A fixed stop is the signal of measuring motions of type 7",
            "Ein Festanschlag ist das Signal von Messfahrten mit Messtyp 7",
        ),
    ),
    Parameter(
        "P-AXIS-00331",
        "kenngr.fixed_stop_pos_lag_limit",
        ValueType.UNS32,
        0,
        Text(
            "Difference of command and actual position above which a fixed stop is found",
            "Abstand von Soll- und Istposition, ab dem ein Festanschlag erkannt ist",
        ),
        unit="0.1 µm, 1e-4°",
    ),
    Parameter(
        "P-AXIS-00332",
        "kenngr.fixed_stop_nbr_cycles",
        ValueType.UNS16,
        0,
        Text(
            "Ticks for which the difference holds at a fixed stop",
            "Takte, die der Abstand an einem Festanschlag bestehen muss",
        ),
    ),
    *(
        Parameter(id_, f"{path}.pos_lag_limit", ValueType.SGN32, -1, Text(en, de), unit=unit)
        for id_, path, unit, en, de in (
            (
                "P-AXIS-00769",
                "antr.fixed_stop.detect",
                "0.1 µm, 1e-4°",
                "Difference at a fixed stop in place of P-AXIS-00331, from 0 on",
                "Abstand an einem Festanschlag anstelle von P-AXIS-00331, ab 0",
            ),
            (
                "P-AXIS-00774",
                "kenngr.measure.fixed_stop_detect",
                "0.1 µm, 1e-4°",
                "Difference at a fixed stop when measuring, before P-AXIS-00769, from 0 on",
                "Abstand an einem Festanschlag beim Messen, vor P-AXIS-00769, ab 0",
            ),
        )
    ),
    *(
        Parameter(id_, f"{path}.min_time", ValueType.UNS32, 0, Text(en, de), unit="µs")
        for id_, path, en, de in (
            (
                "P-AXIS-00770",
                "antr.fixed_stop.detect",
                "Time for which the difference holds, in place of P-AXIS-00332",
                "Zeit, die der Abstand bestehen muss, anstelle von P-AXIS-00332",
            ),
            (
                "P-AXIS-00775",
                "kenngr.measure.fixed_stop_detect",
                "Time for which the difference holds when measuring, before P-AXIS-00770",
                "Zeit, die der Abstand beim Messen bestehen muss, vor P-AXIS-00770",
            ),
        )
    ),
    Parameter(
        "P-AXIS-00118",
        "kenngr.messachse",
        ValueType.BOOLEAN,
        False,
        Text(
            "The axis may take part in measuring motions (G100)",
            "Die Achse darf an Messfahrten (G100) teilnehmen",
        ),
    ),
    Parameter(
        "P-AXIS-00215",
        "kenngr.vb_messen",
        ValueType.UNS32,
        16_666,
        Text("Speed of measuring motions of type 2", "Geschwindigkeit der Messfahrt bei Messtyp 2"),
        low=1,
        unit="µm/s, 1e-3°/s",
        at_most=Limit("P-AXIS-00212"),
    ),
    Parameter(
        "P-AXIS-00114",
        "kenngr.mess_offset",
        ValueType.UNS32,
        0,
        Text(
            "Way behind the target on which a measuring motion of type 2 looks for the signal",
            "Weg hinter dem Ziel, auf dem eine Messfahrt vom Typ 2 das Signal noch sucht",
        ),
        unit=_POSITION,
    ),
    Parameter(
        "P-AXIS-00112",
        "meas_simu.meas_simu_mode",
        ValueType.SGN32,
        1,
        Text(
            "Simulated probe: 1 position, 2 cycles, 3 rest of the way, 4 and 5 target, 6 object",
            "Simulierter Taster: 1 Position, 2 Takte, 3 Restweg, 4 und 5 Ziel, 6 Objekt",
        ),
        low=SIMULATIONS[0],
        high=SIMULATIONS[-1],
    ),
    *(
        Parameter(
            f"P-AXIS-00{144 + number}",
            f"meas_simu.parameter{number}",
            ValueType.SGN32,
            0,
            Text(en, de),
            unit="0.1 µm, 1e-4°; 1; %" if number == 1 else _POSITION,
        )
        for number, en, de in (
            (
                1,
                "Simulated probe: position, cycles or per cent; object: its smallest position",
                "Simulierter Taster: Position, Takte oder Prozent; Objekt: seine kleinste Position",
            ),
            (
                2,
                "Simulated probe, object: its greatest position",
                "Simulierter Taster, Objekt: seine größte Position",
            ),
        )
    ),
)

CHANNEL_MEASURING = (
    Parameter(
        "P-CHAN-00498",
        "range_check_prog_soft_limits",
        ValueType.BOOLEAN,
        False,
        Text(
            "Limits of G98 and G99 beyond those of the lists are ignored",
            "Endschalter von G98 und G99 außerhalb derer der Listen werden nicht beachtet",
        ),
    ),
    Parameter(
        "P-CHAN-00057",
        "messtyp",
        ValueType.UNS16,
        FIRST_TYPE,
        Text("Measuring type with which programs begin", "Messtyp, mit dem Programme beginnen"),
        low=FIRST_TYPE,
        high=LAST_TYPE,
    ),
    *(
        Parameter(id_, path, ValueType.BOOLEAN, default, Text(en, de))
        for id_, path, default, en, de in (
            (
                "P-CHAN-00176",
                "meas_error_no_signal",
                False,
                "Measuring without a signal is an error",
                "Messen ohne Signal ist ein Fehler",
            ),
            (
                "P-CHAN-00266",
                "meas_fixed_stop_no_error",
                False,
                "Measuring type 7 without a fixed stop is no error",
                "Messtyp 7 ohne Festanschlag ist kein Fehler",
            ),
            (
                "P-CHAN-00268",
                "meas_soft_limit_move_path",
                False,
                "Measuring motions end at the software limits instead of being errors",
                "Messfahrten enden an den Softwareendschaltern, statt Fehler zu sein",
            ),
            (
                "P-CHAN-00311",
                "meas_pcs_value_no_probe_radius",
                False,
                "V.A.MEAS.PCS.VALUE does not include the radius of the probe, which is the tool's",
                "V.A.MEAS.PCS.VALUE enthält den Radius des Tasters nicht, den des Werkzeugs",
            ),
            (
                "P-CHAN-00327",
                "meas_all_axes",
                False,
                "All measuring axes are measured while a coordinate system is active",
                "Bei aktivem Koordinatensystem werden alle Messachsen gemessen",
            ),
            (
                "P-CHAN-00312",
                "meas_allow_actuated_probe",
                False,
                "A probe that is pressed at the start ends the measuring there, without an error",
                "Ein zu Beginn gedrückter Taster beendet das Messen dort, ohne Fehler",
            ),
            (
                "P-CHAN-00313",
                "meas_error_no_move_path",
                True,
                "A measuring block without a way is an error",
                "Ein Messsatz ohne Weg ist ein Fehler",
            ),
        )
    ),
)
