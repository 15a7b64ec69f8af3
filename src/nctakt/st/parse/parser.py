# SPDX-License-Identifier: MIT
"""Tokens -> statements and expressions of the tree (ST-501 … 520).

In: the tokens of a piece. Out: nodes of ``tree.py``. The parser parses, the checker rejects: after
a syntax error reading continues at the next statement, and all mistakes are reported. Constructs
that nctakt refuses are named. Nesting is bounded by ``MAX_DEPTH``, the operators of an expression
by ``MAX_OPERATORS``, so that code that walks the tree may recurse.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NoReturn

from nctakt.base.diagnostics import Message
from nctakt.messages.plcs.st_text import (
    COMPARISON_AS_STATEMENT,
    END_KEYWORD_MISSING,
    EXPRESSION_EXPECTED,
    EXPRESSION_TOO_LONG,
    JUMP_REFUSED,
    LONE_EXPRESSION,
    NESTED_TOO_DEEP,
    STATEMENT_EXPECTED,
    TOKEN_EXPECTED,
    TRY_REFUSED,
    UNEXPECTED_TOKEN,
)
from nctakt.st.parse.lexer import ADDRESS, END, KEYWORDS, NAME, NUMBER, STRING, TYPED, Tokens
from nctakt.st.reporting import Reporter
from nctakt.st.tree import (
    Address,
    Argument,
    ArrayInitial,
    Assignment,
    AssignmentExpression,
    Binary,
    Bit,
    Branch,
    Call,
    CallStatement,
    Case,
    CaseBranch,
    Continue,
    Dereference,
    Evaluation,
    Exit,
    For,
    If,
    Index,
    Label,
    Literal,
    Member,
    Name,
    Operator,
    Repeat,
    Repetition,
    Return,
    StructInitial,
    Super,
    This,
    Unary,
    While,
)
from nctakt.st.types import Expression, Statement

#: Maximum depth of nested statements, and of nested brackets in an expression.
MAX_DEPTH = 48
#: Maximum number of operators in a chain of operators of an expression.
MAX_OPERATORS = 160

#: Binary operators by token: precedence (ST-501) and operator.
_BINARY = {
    "OR": (1, Operator.OR),
    "OR_ELSE": (1, Operator.OR_ELSE),
    "XOR": (2, Operator.XOR),
    "AND": (3, Operator.AND),
    "AND_THEN": (3, Operator.AND_THEN),
    "=": (4, Operator.EQUAL),
    "<>": (4, Operator.UNEQUAL),
    "<": (5, Operator.LESS),
    ">": (5, Operator.GREATER),
    "<=": (5, Operator.LESS_EQUAL),
    ">=": (5, Operator.GREATER_EQUAL),
    "+": (6, Operator.ADD),
    "-": (6, Operator.SUBTRACT),
    "*": (7, Operator.MULTIPLY),
    "/": (7, Operator.DIVIDE),
    "MOD": (7, Operator.MOD),
    "**": (8, Operator.POWER),
}
_PREFIX = {"NOT": Operator.NOT, "-": Operator.NEGATE, "+": Operator.PLUS}
_POSTFIX = frozenset((".", "[", "^", "("))
_LITERALS = frozenset((NUMBER, TYPED, STRING, "TRUE", "FALSE"))

#: Tokens that can be in a label of CASE before its colon.
_LABEL_TOKENS = frozenset(
    (NAME, NUMBER, TYPED, STRING, "TRUE", "FALSE", ".", "..", ",", "-", "+", "*", "/")
)
_SET_OPERATORS = {"S": "S=", "R": "R=", "REF": "REF="}
#: Words that begin a member of a block in plain text, if a name or another such word follows.
MEMBER_WORDS = frozenset(("METHOD", "PROPERTY", "ACTION"))
_ENDS = frozenset(
    """END_IF ELSE ELSIF END_CASE END_FOR END_WHILE END_REPEAT UNTIL END_PROGRAM END_FUNCTION
    END_FUNCTION_BLOCK END_METHOD END_PROPERTY END_ACTION END_GET END_SET END_INTERFACE END_TYPE
    PROGRAM FUNCTION FUNCTION_BLOCK INTERFACE TYPE VAR_GLOBAL CONFIGURATION __CATCH __FINALLY
    __ENDTRY""".split()
) | {END}


class SyntaxFaultError(Exception):
    """Reading cannot continue at this token; the fault is reported."""


class TokenReader:
    """The tokens of a piece, a place among them, and reports at them."""

    def __init__(self, tokens: Tokens, reporter: Reporter) -> None:
        self.kinds = tokens.kinds
        self.texts = tokens.texts
        self.starts = tokens.starts
        self.attributes = tokens.attributes
        self.reporter = reporter
        self.index = 0

    @property
    def start(self) -> int:
        """The position of the next token."""
        return self.starts[self.index]

    @property
    def end(self) -> int:
        """The position after the token that was read last."""
        index = self.index - 1
        return self.starts[index] + len(self.texts[index])

    def word(self, ahead: int = 0) -> str:
        """Return a token in upper case."""
        return self.texts[min(self.index + ahead, len(self.texts) - 1)].upper()

    def report(self, message: Message, **values: object) -> None:
        """Report a message at the next token."""
        start = self.start
        self.reporter.report(message, start, start + max(1, len(self.texts[self.index])), **values)

    def fail(self, message: Message, **values: object) -> NoReturn:
        """Report a message at the next token, and give up this statement or declaration."""
        self.report(message, **values)
        raise SyntaxFaultError

    def expect(self, kind: str) -> None:
        """Read a sign or keyword, which has to be there."""
        if self.kinds[self.index] != kind:
            self.fail(TOKEN_EXPECTED, expected=kind, found=self._found())
        self.index += 1

    def accept(self, kind: str) -> bool:
        """Read a sign or keyword if it is there; return whether it was."""
        if self.kinds[self.index] == kind:
            self.index += 1
            return True
        return False

    def accept_word(self, word: str) -> bool:
        """Read a word that is not a keyword, if it is there; return whether it was."""
        if self.kinds[self.index] == NAME and self.word() == word:
            self.index += 1
            return True
        return False

    def name(self) -> str:
        """Read a name, which has to be there."""
        if self.kinds[self.index] != NAME:
            self.fail(TOKEN_EXPECTED, expected="name", found=self._found())
        self.index += 1
        return self.texts[self.index - 1]

    def _found(self) -> str:
        return self.texts[self.index] or "–"


class ExpressionParser(TokenReader):
    """Reads expressions and initial values."""

    def __init__(self, tokens: Tokens, reporter: Reporter) -> None:
        super().__init__(tokens, reporter)
        self._depth = 0

    def expression(self, precedence: int = 1) -> Expression:
        """Read an expression whose operators bind at least as strongly as ``precedence``."""
        kinds = self.kinds
        kind = kinds[self.index]
        if kind in _PREFIX:
            left = self._prefix(kind)
        else:
            left = self._primary(kind)
            if kinds[self.index] in _POSTFIX:
                left = self._postfix(left)
        count = 0
        while (found := _BINARY.get(kinds[self.index])) is not None and found[0] >= precedence:
            count += 1
            if count > MAX_OPERATORS:
                self.fail(EXPRESSION_TOO_LONG, limit=MAX_OPERATORS)
            self.index += 1
            right = self.expression(found[0] + 1)
            left = Binary(left.start, right.end, found[1], left, right)
        return left

    def _prefix(self, kind: str) -> Expression:
        start = self.start
        self._enter()
        self.index += 1
        inner = self.kinds[self.index]
        if inner in _PREFIX:
            operand = self._prefix(inner)
        else:
            operand = self._primary(inner)
            if self.kinds[self.index] in _POSTFIX:
                operand = self._postfix(operand)
        self._depth -= 1
        return Unary(start, operand.end, _PREFIX[kind], operand)

    def _enter(self) -> None:
        """Count a level of nesting; the caller counts down again unless reading fails."""
        self._depth += 1
        if self._depth > MAX_DEPTH:
            self.fail(NESTED_TOO_DEEP, limit=MAX_DEPTH)

    def _primary(self, kind: str) -> Expression:
        index = self.index
        start = self.starts[index]
        text = self.texts[index]
        if kind == NAME:
            self.index = index + 1
            if self.kinds[index + 1] == "TO" and text.upper() in ("POINTER", "REFERENCE"):
                self.index = index
                return self._type_expression()
            return Name(start, start + len(text), text)
        if kind in _LITERALS:
            self.index = index + 1
            if kind == TYPED:
                prefix, _, text = text.partition("#")
                return Literal(start, self.end, text, prefix.upper())
            return Literal(start, start + len(text), text)
        if kind == "(":
            self._enter()
            self.index = index + 1
            inner = self.expression()
            if self.kinds[self.index] == ":=":
                self.index += 1
                inner = AssignmentExpression(inner.start, 0, inner, self.expression())
                inner.end = self.end
            self.expect(")")
            self._depth -= 1
            return inner
        if kind in ("THIS", "SUPER"):
            self.index = index + 1
            return (This if kind == "THIS" else Super)(start, start + len(text))
        if kind == "." and self.kinds[index + 1] == NAME:
            self.index = index + 2
            return Name(start, self.end, self.texts[index + 1], True)
        if kind == ADDRESS:
            self.index = index + 1
            return Address(start, start + len(text), text)
        self.fail(EXPRESSION_EXPECTED, found=text or "–")

    def _type_expression(self) -> Expression:
        """Read a type in place of a value: the argument of SIZEOF."""
        self.fail(EXPRESSION_EXPECTED, found=self.texts[self.index])

    def _postfix(self, left: Expression) -> Expression:
        kinds, texts = self.kinds, self.texts
        count = 0
        while (kind := kinds[self.index]) in _POSTFIX:
            count += 1
            if count > MAX_OPERATORS:
                self.fail(EXPRESSION_TOO_LONG, limit=MAX_OPERATORS)
            self.index += 1
            if kind == ".":
                text = texts[self.index]
                following = kinds[self.index]
                if following == NUMBER and text.isdecimal() and len(text) < 4:
                    self.index += 1
                    left = Bit(left.start, self.end, left, int(text))
                elif following == NAME or following in KEYWORDS:
                    self.index += 1
                    left = Member(left.start, self.end, left, text)
                else:
                    self.fail(TOKEN_EXPECTED, expected="name", found=self._found())
            elif kind == "^":
                left = Dereference(left.start, self.end, left)
            elif kind == "[":
                self._enter()
                indices = [self.expression()]
                while self.accept(","):
                    indices.append(self.expression())
                self.expect("]")
                self._depth -= 1
                left = Index(left.start, self.end, left, indices)
            else:
                arguments = self.arguments()
                left = Call(left.start, self.end, left, arguments)
        return left

    def arguments(self) -> list[Argument]:
        """Read the arguments of a call, whose opening bracket has been read, and the closing one.

        An argument without a value (``Q =>``) is as if it were not there.
        """
        arguments: list[Argument] = []
        self._enter()
        while not self.accept(")"):
            start = self.start
            name, is_output = "", False
            if self.kinds[self.index] == NAME and self.kinds[self.index + 1] in (":=", "=>"):
                name = self.texts[self.index]
                is_output = self.kinds[self.index + 1] == "=>"
                self.index += 2
            value = None
            if not (name and self.kinds[self.index] in (",", ")")):
                value = self.initial_value()
            arguments.append(Argument(start, self.end, name, value, is_output))
            if not self.accept(","):
                self.expect(")")
                break
        self._depth -= 1
        return arguments

    def initial_value(self) -> Expression:
        """Read an initial value: an expression, ``[…]``, or ``(member := …)``."""
        kind, start = self.kinds[self.index], self.start
        if kind == "[":
            self.index += 1
            self._enter()
            items = []
            while not self.accept("]"):
                items.append(self._item())
                if not self.accept(","):
                    self.expect("]")
                    break
            self._depth -= 1
            return ArrayInitial(start, self.end, items)
        if kind == "(" and self._is_struct_initial():
            self.index += 1
            arguments = self.arguments()
            return StructInitial(start, self.end, arguments)
        return self.expression()

    def _is_struct_initial(self) -> bool:
        kinds, index = self.kinds, self.index
        return kinds[index + 1] == ")" or (kinds[index + 1] == NAME and kinds[index + 2] == ":=")

    def _item(self) -> Expression | Repetition:
        """Read an item of ``[…]``: a value, or values that are repeated."""
        start = self.start
        if self.kinds[self.index] == NUMBER and self.kinds[self.index + 1] == "(":
            count = self._primary(NUMBER)
            self.index += 1
            self._enter()
            values = []
            while not self.accept(")"):
                values.append(self.initial_value())
                if not self.accept(","):
                    self.expect(")")
                    break
            self._depth -= 1
            return Repetition(start, self.end, count, values)
        return self.initial_value()


class StatementParser(ExpressionParser):
    """Reads the statements of a body."""

    def __init__(self, tokens: Tokens, reporter: Reporter, *, is_plain: bool = False) -> None:
        super().__init__(tokens, reporter)
        self._is_plain = is_plain
        self._statements: dict[str, Callable[[int], Statement | None]] = {
            "IF": self._if,
            "CASE": self._case,
            "FOR": self._for,
            "WHILE": self._while,
            "REPEAT": self._repeat,
            "EXIT": self._simple,
            "CONTINUE": self._simple,
            "RETURN": self._simple,
            "JMP": self._jump,
            "__TRY": self._try,
        }

    def whole_body(self) -> list[Statement]:
        """Read all statements of a piece that holds nothing else."""
        statements: list[Statement] = []
        while True:
            statements += self.statements()
            if self.kinds[self.index] == END:
                return statements
            if not self.word().startswith("END_") or self.kinds[self.index + 1] not in (END, ";"):
                self.report(UNEXPECTED_TOKEN, found=self.texts[self.index])
            self.index += 1

    def statements(self, *, is_case: bool = False) -> list[Statement]:
        """Read statements up to a keyword that ends them; in CASE up to the next label, too."""
        found: list[Statement] = []
        kinds = self.kinds
        depth = self._depth
        while (kind := kinds[self.index]) not in _ENDS:
            if kind == ";":
                self.index += 1
                continue
            if is_case and self._is_label():
                break
            if self._is_plain and self._begins_member():
                break
            try:
                if kind == NAME:
                    statement = self._expression_statement()
                elif (method := self._statements.get(kind)) is not None:
                    self._enter()
                    statement = method(self.starts[self.index])
                    self._depth -= 1
                else:
                    statement = self._expression_statement()
            except SyntaxFaultError:
                self._depth = depth
                self._recover()
                continue
            if statement is not None:
                found.append(statement)
        return found

    def _recover(self) -> None:
        """Go to the end of a statement with a fault: a semicolon, or a keyword."""
        kinds = self.kinds
        while True:
            kind = kinds[self.index]
            if kind in _ENDS:
                return
            self.index += 1
            if kind == ";" or kinds[self.index] in self._statements:
                return

    def _begins_member(self) -> bool:
        """Whether METHOD, PROPERTY or ACTION of plain text is next."""
        index = self.index
        return (
            self.kinds[index] == NAME
            and self.kinds[index + 1] == NAME
            and self.texts[index].upper() in MEMBER_WORDS
        )

    def _is_label(self) -> bool:
        """Whether a label of CASE is next."""
        kinds, index = self.kinds, self.index
        if kinds[index] == "(":
            return True
        while kinds[index] in _LABEL_TOKENS:
            index += 1
        return kinds[index] == ":" and index > self.index

    def _expression_statement(self) -> Statement | None:
        """Read an assignment or a call."""
        kinds = self.kinds
        start = self.starts[self.index]
        kind = kinds[self.index]
        if kind == NAME and kinds[self.index + 1] == ":":
            self.fail(JUMP_REFUSED, word=self.texts[self.index])
        if kind != NAME and kind not in ("THIS", "SUPER", "(", ".", ADDRESS):
            if kind in _LITERALS or kind in _PREFIX:
                return self._lone(self.expression())
            self.fail(STATEMENT_EXPECTED, found=self.texts[self.index])
        target = self._primary(kind)
        if kinds[self.index] in _POSTFIX:
            target = self._postfix(target)
        operator = kinds[self.index]
        if operator == ":=":
            self.index += 1
        elif operator == NAME and kinds[self.index + 1] == "=":
            operator = _SET_OPERATORS.get(self.texts[self.index].upper(), "")
            if not operator:
                return self._lone(target)
            self.index += 2
        elif isinstance(target, Call):
            self._semicolon()
            return CallStatement(start, target.end, target)
        else:
            return self._lone(target)
        value = self._assigned()
        self._semicolon()
        return Assignment(start, value.end, target, operator, value)

    def _assigned(self) -> Expression:
        """Read the right side of an assignment, which may be an assignment itself: ``b := c``."""
        values = [self.initial_value()]
        while self.accept(":="):
            values.append(self.expression())
            if len(values) > MAX_DEPTH:
                self.fail(NESTED_TOO_DEEP, limit=MAX_DEPTH)
        value = values.pop()
        while values:
            target = values.pop()
            value = AssignmentExpression(target.start, value.end, target, value)
        return value

    def _lone(self, expression: Expression) -> Statement:
        """Return a statement that may read a property, and report any other lone expression."""
        kind = self.kinds[self.index]
        if kind == "=":
            self.fail(COMPARISON_AS_STATEMENT)
        if kind == ";" and isinstance(expression, Member | Dereference):
            self.index += 1
            return Evaluation(expression.start, expression.end, expression)
        if kind == ";" or kind in _BINARY or kind in _ENDS:
            self.reporter.report(LONE_EXPRESSION, expression.start, expression.end)
            raise SyntaxFaultError
        self.fail(UNEXPECTED_TOKEN, found=self.texts[self.index] or "–")

    def _semicolon(self) -> None:
        """Read the semicolon of a statement; without one reading continues at this token."""
        if self.kinds[self.index] == ";":
            self.index += 1
        else:
            end = self.end
            self.reporter.report(
                TOKEN_EXPECTED, end, end + 1, expected=";", found=self.texts[self.index] or "–"
            )
            if self.kinds[self.index] not in (*_ENDS, NAME, *self._statements):
                raise SyntaxFaultError

    def _close(self, keyword: str, start: int) -> None:
        """Read the keyword that ends a statement which began at ``start``."""
        if not self.accept(keyword):
            self.reporter.report(
                END_KEYWORD_MISSING,
                self.start,
                self.start + max(1, len(self.texts[self.index])),
                keyword=keyword,
                line=self.reporter.sources.line_number(start),
                found=self.texts[self.index] or "–",
            )

    def _if(self, start: int) -> Statement:
        branches: list[Branch] = []
        otherwise: list[Statement] = []
        while self.kinds[self.index] in ("IF", "ELSIF"):
            if branches and self.kinds[self.index] == "IF":
                break
            begin = self.start
            self.index += 1
            condition = self.expression()
            self.expect("THEN")
            body = self.statements()
            branches.append(Branch(begin, condition.end, condition, body))
        if self.accept("ELSE"):
            otherwise = self.statements()
        self._close("END_IF", start)
        return If(start, branches[0].end, branches, otherwise)

    def _case(self, start: int) -> Statement:
        self.index += 1
        selector = self.expression()
        self.expect("OF")
        branches: list[CaseBranch] = []
        otherwise: list[Statement] = []
        while self.kinds[self.index] not in _ENDS:
            if self.accept(";"):
                continue
            begin = self.start
            labels = [self._label()]
            while self.accept(","):
                labels.append(self._label())
            self.expect(":")
            end = self.end
            branches.append(CaseBranch(begin, end, labels, self.statements(is_case=True)))
        if self.accept("ELSE"):
            self.accept(":")
            otherwise = self.statements()
        self._close("END_CASE", start)
        return Case(start, selector.end, selector, branches, otherwise)

    def _label(self) -> Label:
        low = self.expression()
        high = self.expression() if self.accept("..") else None
        return Label(low.start, self.end, low, high)

    def _for(self, start: int) -> Statement:
        self.index += 1
        counter = self._primary(self.kinds[self.index])
        if self.kinds[self.index] in _POSTFIX:
            counter = self._postfix(counter)
        self.expect(":=")
        first = self.expression()
        self.expect("TO")
        last = self.expression()
        step = self.expression() if self.accept("BY") else None
        self.expect("DO")
        end = self.end
        body = self.statements()
        self._close("END_FOR", start)
        return For(start, end, counter, first, last, step, body)

    def _while(self, start: int) -> Statement:
        self.index += 1
        condition = self.expression()
        self.expect("DO")
        body = self.statements()
        self._close("END_WHILE", start)
        return While(start, condition.end, condition, body)

    def _repeat(self, start: int) -> Statement:
        self.index += 1
        body = self.statements()
        self.expect("UNTIL")
        condition = self.expression()
        self.accept(";")
        self._close("END_REPEAT", start)
        return Repeat(start, condition.end, body, condition)

    def _simple(self, start: int) -> Statement:
        kind = self.kinds[self.index]
        self.index += 1
        node = {"EXIT": Exit, "CONTINUE": Continue, "RETURN": Return}[kind](start, self.end)
        self._semicolon()
        return node

    def _jump(self, start: int) -> None:
        self.fail(JUMP_REFUSED, word="JMP")

    def _try(self, start: int) -> None:
        """Refuse __TRY; its statements are read, so that their mistakes are reported."""
        self.report(TRY_REFUSED)
        self.index += 1
        while True:
            self.statements()
            kind = self.kinds[self.index]
            if kind not in ("__CATCH", "__FINALLY", "__ENDTRY"):
                return
            self.index += 1
            if kind == "__ENDTRY":
                return
            if kind == "__CATCH" and self.accept("("):
                self.arguments()
