# SPDX-License-Identifier: MIT
"""Positions that an axis never reaches: in conditions, and as targets of independent motions.

In: a comparison, an axis command; the software limits or modulo ranges of the axes. Out: a warning
(901052) where the comparison has one result for all positions, an error (60158) where a run would
refuse the target. Only positions of the axis coordinate system count: no offset shifts them.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.messages.axes.axis_motions import INDP_TARGET_OUTSIDE_LIMITS
from nctakt.messages.programs.lints import POSITION_NEVER_REACHED
from nctakt.nc.check.findings import Findings
from nctakt.nc.lint.constants import constant
from nctakt.nc.lint.uses import always, is_position
from nctakt.nc.tree import Binary, Variable
from nctakt.nc.vocabulary.single_axes.axis_commands import AxisCommand
from nctakt.nc.vocabulary.variables.resolution import path_text
from nctakt.nc.vocabulary.variables.variable_table import NameTable

ALWAYS_TRUE = Text("always true", "immer wahr")
NEVER_TRUE = Text("never true", "nie wahr")

_MM_PER_INCH = 25.4


def check_comparison(
    comparison: Binary,
    variable: Variable,
    operator: str,
    value: float,
    names: NameTable,
    findings: Findings,
    *,
    is_inch: bool,
) -> None:
    """Report a comparison of an axis' position with a constant that the axis cannot reach."""
    if not is_position(variable, "ACT_POS", "CUR_POS", "CMD_POS"):
        return
    system, *_, name = [part.name for part in variable.parts]
    axis = names.axis(name)
    if axis is None or system != "ACS":
        return
    unit = _MM_PER_INCH if is_inch and axis.is_linear else 1.0
    low, high = axis.low / unit, axis.high / unit
    if low <= value <= high:
        return
    truth = operator == "!=" if operator in ("==", "!=") else always(operator, value, low, high)
    if truth is not None:
        findings.report(
            POSITION_NEVER_REACHED,
            comparison.span,
            name=path_text(variable),
            low=low,
            high=high,
            result=ALWAYS_TRUE if truth else NEVER_TRUE,
        )


def check_target(
    command: AxisCommand, names: NameTable, findings: Findings, *, is_inch: bool
) -> None:
    """Report a constant target of ``X[INDP G90 POS=…]`` that a run would refuse."""
    axis = names.axis(command.axis)
    if axis is None or axis.is_modulo or command.position is None:
        return
    value = constant(command.position)
    if value is None or not command.absolute or command.offset:
        return
    target = value * (_MM_PER_INCH if is_inch and axis.is_linear else 1.0)
    if not axis.low <= target <= axis.high:
        findings.report(
            INDP_TARGET_OUTSIDE_LIMITS,
            command.position.span,
            axis=command.axis,
            target=target,
            low=axis.low,
            high=axis.high,
        )
