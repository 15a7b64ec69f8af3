# SPDX-License-Identifier: MIT
"""A single expression, checked after its project: a condition or a question of a debugger.

In: a text, and the POU, method or action whose names it sees. Out: the expression with its type.
Its mistakes are raised, and the project is unchanged.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Severity
from nctakt.base.failure import Failure
from nctakt.messages.plcs.st_text import UNEXPECTED_TOKEN
from nctakt.st.check.names import Scope
from nctakt.st.check.statements import StatementChecker
from nctakt.st.parse.lexer import END, Definitions, Lexer
from nctakt.st.parse.parser import ExpressionParser, SyntaxFaultError
from nctakt.st.sources import Piece
from nctakt.st.types import Callable, Expression, Method, Pou

#: The name of such a text in messages.
FILE = "expression"
#: Maximum length of such a text, and number of different texts kept.
MAX_CHARACTERS = 1000
MAX_KEPT = 10_000


class SingleExpressions:
    """Reads expressions in the scopes of a project that has been checked."""

    def __init__(self, checker: StatementChecker) -> None:
        self._checker = checker
        self._known: dict[tuple[str, int], Expression] = {}

    def read(self, text: str, unit: Callable | None) -> Expression:
        """Return an expression in the scope of a unit, ``None``: that of global names.

        Raises ``Failure`` with its mistakes.
        """
        key = text, id(unit)
        found = self._known.get(key)
        if found is None:
            found = self._read(text, unit)
            if len(self._known) < MAX_KEPT:
                self._known[key] = found
        return found

    def _read(self, text: str, unit: Callable | None) -> Expression:
        checker = self._checker
        reporter = checker.reporter
        with reporter.apart() as collector:
            piece = reporter.sources.add(Piece(FILE, text, [0], [1], [1]))
            reporter.sources.lines[FILE] = [text]
            expression: Expression | None = None
            try:
                parser = ExpressionParser(Lexer(piece, Definitions(), reporter).read(), reporter)
                expression = parser.expression()
                if parser.kinds[parser.index] != END:
                    parser.report(UNEXPECTED_TOKEN, found=parser.texts[parser.index])
                self._check(expression, unit)
            except SyntaxFaultError:
                pass  # it is reported
        errors = [one for one in collector.diagnostics if one.severity is Severity.ERROR]
        if errors or expression is None:
            raise Failure(*errors)
        return expression

    def _check(self, expression: Expression, unit: Callable | None) -> None:
        checker = self._checker
        scope, checker.scope = checker.scope, Scope()
        try:
            if isinstance(unit, Pou | Method) and unit in checker.resolver.nodes:
                checker.scope = checker.resolver.nodes[unit][1]
            checker.expression(expression)
        finally:
            checker.scope = scope
