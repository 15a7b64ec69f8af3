# SPDX-License-Identifier: MIT
"""Declarations and deletion of program variables: V.P, V.S, V.L, V.CYC.

In: ``#VAR`` and ``#DELETE``. Out: diagnostics.
"""

from __future__ import annotations

from nctakt.base.diagnostics import NOTHING, number_text
from nctakt.base.misspelling import nearest
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.messages.programs.checked_values import (
    INVALID_ELEMENT_COUNT,
    NOT_A_PROGRAM_VARIABLE,
    UNKNOWN_TYPE,
)
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.words import DECLARED_TYPES
from nctakt.nc.tree import (
    ArrayLiteral,
    Declaration,
    HashCommand,
    Node,
    Number,
    Variable,
    VariableDeclarations,
)
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.variables.resolution import (
    PROGRAM_FAMILIES,
    indices_of,
    is_program_variable,
    path_text,
)


class ProgramVariableChecker:
    """Checks the declarations of one program."""

    def __init__(self, values: ValueChecker, findings: Findings) -> None:
        self._values = values
        self._findings = findings

    def declarations(self, statement: VariableDeclarations) -> None:
        """Check ``#VAR`` … ``#ENDVAR``."""
        for declaration in statement.declarations:
            self._declaration(declaration)

    def _declaration(self, declaration: Declaration) -> None:
        variable = declaration.variable
        if not is_program_variable(variable):
            self._report_no_program_variable(variable)
            return
        self._values.write(variable)
        for index in indices_of(variable):
            if isinstance(index, Number) and not 1 <= index.value == int(index.value):
                name = path_text(variable)
                self._findings.report(
                    INVALID_ELEMENT_COUNT, index.span, name=name, count=number_text(index.value)
                )
        if declaration.type_name is not None and declaration.type_name not in DECLARED_TYPES:
            word = declaration.type_name
            near = nearest(word, DECLARED_TYPES) or NOTHING
            self._findings.report(UNKNOWN_TYPE, declaration.span, word=word, nearest=near)
        if declaration.size is not None:
            self._values.value(declaration.size)
        if isinstance(declaration.initial, ArrayLiteral):
            self._values.list_items(declaration.initial)
        elif declaration.initial is not None:
            self._values.any_value(declaration.initial)

    def _report_no_program_variable(self, node: Node) -> None:
        word = self._findings.written(node.span)
        families = ", ".join(f"V.{family}" for family in PROGRAM_FAMILIES)
        self._findings.report(NOT_A_PROGRAM_VARIABLE, node.span, word=word, families=families)

    def delete(self, command: HashCommand) -> None:
        """Check ``#DELETE V.P.A, V.S.B``; a family alone, ``V.P.``, means all its variables."""
        if not command.arguments:
            forms = forms_of("#DELETE")
            self._findings.report(
                INVALID_COMMAND_FORM, command.span, command="#DELETE", forms=forms
            )
        for argument in command.arguments:
            if not isinstance(argument, Variable) or not is_program_variable(argument):
                self._report_no_program_variable(argument)
