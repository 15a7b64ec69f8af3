# SPDX-License-Identifier: MIT
"""Tree -> NC text; parsing the text gives the same tree again.

In: nodes of ``tree.py`` from the parser. Out: lines, indented by two blanks for each structure.
Comments and the numbers of closing lines are not in the tree and therefore not in the text.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from nctakt.nc.tree import (
    PARAMETER_ARRAYS,
    ArrayLiteral,
    Assignment,
    AxisWord,
    Binary,
    Block,
    BlockWord,
    Bracket,
    BracketCommand,
    Break,
    Call,
    Case,
    Constant,
    Continue,
    CycleControl,
    Declaration,
    Do,
    Expression,
    Flush,
    For,
    Goto,
    HashCommand,
    Head,
    If,
    Keyword,
    MacroDefinition,
    Name,
    Number,
    OffsetCommand,
    Parameter,
    Program,
    ProgramStart,
    RealtimeCycle,
    RealtimeLoop,
    Repeat,
    Statement,
    StringLiteral,
    StringWord,
    SubprogramCall,
    Switch,
    Time,
    Timer,
    Unary,
    Unreadable,
    UserError,
    UserMessage,
    Variable,
    VariableBlock,
    VariableDeclarations,
    While,
    Word,
)
from nctakt.nc.vocabulary.operators import INFIX, PREFIX

#: Precedence of a node that never needs brackets.
_ATOM = 100
_NO_WORDS = frozenset(("MOD", "XOR"))


# --- expressions ---------------------------------------------------------------------------------


def format_number(value: float) -> str:
    """Return the shortest digits of a value, without an exponent."""
    if value == int(value):
        return str(int(value))
    from decimal import Decimal  # noqa: PLC0415 - rarely needed

    return format(Decimal(repr(value)), "f")


def format_expression(node: Expression) -> str:
    """Return one expression, with brackets only where precedence needs them."""
    return _FORMATS[type(node)](node)


def _format_binary(node: Binary) -> str:
    operator = INFIX[node.operator]
    right_associative = operator.right_associative
    left = _operand(node.left, operator.precedence + right_associative)
    right = _operand(node.right, operator.precedence + (not right_associative), right=True)
    return f"{left} {node.operator} {right}"


def _operand(node: Expression, minimum: int, *, right: bool = False) -> str:
    text = format_expression(node)
    if right and _has_prefix(node):
        # A prefix may begin any operand, whatever the precedence of the operator.
        return text
    return text if _strength(node) >= minimum else f"[{text}]"


def _has_prefix(node: Expression) -> bool:
    return isinstance(node, Unary) or (isinstance(node, Number) and node.value < 0)


def _strength(node: Expression) -> int:
    if isinstance(node, Binary):
        return INFIX[node.operator].precedence
    if _has_prefix(node):
        return PREFIX["-"].precedence
    return _ATOM


def _format_unary(node: Unary) -> str:
    operand = _operand(node.operand, PREFIX[node.operator].precedence)
    return f"{node.operator} {operand}" if node.operator.isalpha() else node.operator + operand


def _format_variable(node: Variable) -> str:
    if node.family == PARAMETER_ARRAYS:
        (part,) = node.parts
        return f"P{part.name}{_indices(part.indices)}"
    parts = "".join(f".{part.name}{_indices(part.indices)}" for part in node.parts)
    return f"{'Vs' if node.synchronous else 'V'}.{node.family}{parts or '.'}"


def _indices(indices: tuple[Expression, ...]) -> str:
    return "".join(f"[{format_expression(index)}]" for index in indices)


def _format_parameter(node: Parameter) -> str:
    sign = "@P" if node.call else "P"
    index = node.index
    if isinstance(index, Number) and index.value >= 0 and index.value == int(index.value):
        return sign + format_number(index.value)
    return f"{sign}[{format_expression(index)}]"


def _list(items: tuple[Expression, ...]) -> str:
    return f"[{', '.join(format_expression(item) for item in items)}]"


_FORMATS: dict[type[Expression], Callable[[Any], str]] = {
    Number: lambda node: format_number(node.value),
    StringLiteral: lambda node: f'"{node.value}"',
    Constant: lambda node: node.name,
    Name: lambda node: node.text,
    Variable: _format_variable,
    Parameter: _format_parameter,
    Unary: _format_unary,
    Binary: _format_binary,
    Call: lambda node: node.function + _list(node.arguments),
    ArrayLiteral: lambda node: _list(node.items),
}


# --- keywords and words --------------------------------------------------------------------------


def format_items(items: tuple[Keyword | Expression, ...]) -> str:
    """Return ``[ … ]`` with keywords and values; commas where a blank could join two of them."""
    parts: list[str] = []
    for item in items:
        if parts:
            joins = not isinstance(item, Keyword) or item.name in _NO_WORDS
            parts.append(", " if joins else " ")
        parts.append(_format_item(item))
    return f"[{''.join(parts)}]"


def _format_item(item: Keyword | Expression, *, glued: bool = True) -> str:
    if isinstance(item, Name):
        return f"[{item.text}]"  # without brackets it would be a keyword
    if isinstance(item, Expression):
        return format_expression(item)
    if item.value is None:
        return item.name + (format_items(item.arguments) if item.arguments else "")
    if item.arguments:
        return f"{item.name}{format_items(item.arguments)}={format_expression(item.value)}"
    if glued and item.name in ("G", "M", "H") and _is_natural(item.value):
        return item.name + format_expression(item.value)
    return f"{item.name}={format_expression(item.value)}"


def _is_natural(value: Expression) -> bool:
    return isinstance(value, Number) and value.value >= 0 and value.value == int(value.value)


def format_word(word: BlockWord) -> str:
    """Return one word of a block."""
    if isinstance(word, StringWord):
        return f'"{word.text}"'
    if isinstance(word, BracketCommand):
        return word.name + format_items(word.items)
    assert isinstance(word, Word | AxisWord)
    if word.value is None:
        return word.name
    if len(word.name) > 1 or word.name in "LP" or not isinstance(word.value, Number):
        if isinstance(word, Word) and word.additional is not None:
            number, additional = format_expression(word.value), format_expression(word.additional)
            return f"{word.name}[{number}]={additional}"
        return f"{word.name}={format_expression(word.value)}"
    text = word.name + format_number(word.value.value)
    if isinstance(word, Word) and word.additional is not None:
        return f"{text}={format_expression(word.additional)}"
    if isinstance(word, Word) and word.arguments:
        return text + _list(word.arguments)
    return text


# --- statements ----------------------------------------------------------------------------------


def print_program(program: Program) -> str:
    """Return the whole program: main program first, then the local subprograms."""
    lines: list[str] = []
    if program.name:
        lines.append(f"%{program.name}")
    lines += _body(program.statements, "")
    for subprogram in program.subprograms:
        lines.append(f"%L {subprogram.name}")
        lines += _body(subprogram.statements, "")
    return "".join(f"{line}\n" for line in lines)


def print_statement(statement: Statement, indent: str = "") -> Iterator[str]:
    """Yield the lines of one statement."""
    simple = _SIMPLE.get(type(statement))
    if simple is None:
        yield from _STRUCTURES[type(statement)](statement, indent)
        return
    line = format_head(statement.head) + simple(statement)
    yield indent + line.rstrip()


def format_head(head: Head) -> str:
    """Return skip level, number and label followed by a blank; empty without them."""
    text = ""
    if head.skip is not None:
        text = "/ " if head.skip == 1 else f"/{head.skip} "
    if head.number is not None:
        literal = _is_natural(head.number)
        number = (
            format_expression(head.number) if literal else f"[{format_expression(head.number)}]"
        )
        if head.label == f"N{number}":
            return f"{text}N{number}: "
        text += f"N{number} "
    return text if head.label is None else f"{text}[{head.label}] "


def _body(statements: tuple[Statement, ...], indent: str) -> Iterator[str]:
    for statement in statements:
        yield from print_statement(statement, indent)


def _format_call(call: SubprogramCall) -> str:
    word = "LL" if call.local else "L"
    if call.cycle:
        named = Keyword(call.span, "NAME", call.name)
        name = "CYCLE " + format_items((named, *call.keywords))
    elif isinstance(call.name, StringLiteral):
        plain = call.name.value.replace(".", "").replace("_", "").isalnum()
        variable = call.name.value.upper().startswith(("V.", "VS."))
        name = call.name.value if plain and not variable else format_expression(call.name)
    else:
        name = format_expression(call.name)
    return " ".join([word, name, *(format_word(other) for other in call.words)])


def _format_hash(command: HashCommand) -> str:
    words = " ".join(word.text for word in command.words)
    is_coupling = any(word.name == "LINK" for word in command.words)
    arguments = ", ".join(
        _format_couplings(argument.items)
        if isinstance(argument, Bracket) and is_coupling
        else format_items(argument.items)
        if isinstance(argument, Bracket)
        else _format_item(argument, glued=False)
        for argument in command.arguments
    )
    return f"#{words} {arguments}"


def _format_couplings(items: tuple[Keyword | Expression, ...]) -> str:
    return "[" + ", ".join(map(_format_coupling, items)) + "]"


def _format_coupling(item: Keyword | Expression) -> str:
    if not isinstance(item, Keyword) or item.value is None:
        return _format_item(item, glued=False)
    slave, rest = item.name, item.arguments
    if not slave:
        slave, rest = _format_item(rest[0], glued=False), rest[1:]
    pair = f"{slave} = {format_expression(item.value)}"
    further = ", ".join(_format_item(one, glued=False) for one in rest)
    return f"[{pair}, {further}]" if rest else pair


def _format_offsets(command: OffsetCommand) -> str:
    kinds = _optional_items(command.kinds)
    return " ".join([f"#{command.name} {kinds}", *(format_word(word) for word in command.words)])


def _format_message(message: UserMessage) -> str:
    options = "".join(f"{option.text} " for option in message.options)
    return f"#MSG {options}{_list((message.format, *message.arguments))}"


def _format_timer(timer: Timer) -> str:
    options = "".join(f"{option.text} " for option in timer.options)
    return f"#TIMER {timer.action} {options}{_optional_items(timer.keywords)}"


def _optional_items(items: tuple[Keyword | Expression, ...]) -> str:
    return format_items(items) if items else ""


def _format_assignment(node: Assignment) -> str:
    target, value = format_expression(node.target), format_expression(node.value)
    return f"{target} {node.operator} {value}"


def _format_start(start: ProgramStart) -> str:
    return f"%{'L ' if start.local else ''}{start.name}"


_SIMPLE: dict[type[Statement], Callable[[Any], str]] = {
    Block: lambda node: " ".join(format_word(word) for word in node.words),
    SubprogramCall: _format_call,
    Assignment: _format_assignment,
    VariableBlock: lambda node: format_expression(node.variable),
    MacroDefinition: lambda node: '"{}" = "{}"'.format(node.name, node.text.replace('"', '\\"')),
    Goto: lambda node: "$GOTO " + _format_label(node.label),
    Break: lambda _: "$BREAK",
    Continue: lambda _: "$CONTINUE",
    CycleControl: lambda node: f"#RT CYCLE {node.action} {_optional_items(node.keywords)}",
    Flush: lambda node: f"#FLUSH {node.mode or ''}",
    Time: lambda node: f"#TIME {format_expression(node.seconds)}",
    UserMessage: _format_message,
    Timer: _format_timer,
    UserError: lambda node: f"#ERROR {_optional_items(node.keywords)}",
    HashCommand: _format_hash,
    OffsetCommand: _format_offsets,
    ProgramStart: _format_start,
    Unreadable: lambda node: node.text,
}


def _format_label(label: str) -> str:
    return label if label[:1] == "N" and label[1:].isdigit() else f"[{label}]"


def _frequency(frequency: str | None) -> str:
    return f"{frequency} " if frequency else ""


def _print_if(node: If, indent: str) -> Iterator[str]:
    sign = "#" if node.preprocessor else "$"
    condition = format_expression(node.condition)
    head = format_head(node.head)
    yield f"{indent}{head}{sign}IF {_frequency(node.frequency)}{condition}"
    yield from _body(node.body, indent + "  ")
    for branch in node.elseifs:
        condition = format_expression(branch.condition)
        head = format_head(branch.head)
        yield f"{indent}{head}{sign}ELSEIF {_frequency(branch.frequency)}{condition}"
        yield from _body(branch.body, indent + "  ")
    if node.else_body is not None:
        yield f"{indent}{sign}ELSE"
        yield from _body(node.else_body, indent + "  ")
    yield f"{indent}{sign}ENDIF"


def _print_for(node: For, indent: str) -> Iterator[str]:
    bounds = ", ".join(format_expression(bound) for bound in (node.start, node.end, node.step))
    yield f"{indent}{format_head(node.head)}$FOR {format_expression(node.variable)} = {bounds}"
    yield from _body(node.body, indent + "  ")
    yield f"{indent}$ENDFOR"


def _print_while(node: While, indent: str) -> Iterator[str]:
    yield f"{indent}{format_head(node.head)}$WHILE {format_expression(node.condition)}"
    yield from _body(node.body, indent + "  ")
    yield f"{indent}$ENDWHILE"


def _print_realtime_loop(node: RealtimeLoop, indent: str) -> Iterator[str]:
    yield f"{indent}{format_head(node.head)}#RT WHILE{' [MODULO]' if node.modulo else ''}"
    yield from _body(node.body, indent + "  ")
    yield f"{indent}#RT ENDWHILE"


def _print_do(node: Do, indent: str) -> Iterator[str]:
    yield f"{indent}{format_head(node.head)}$DO"
    yield from _body(node.body, indent + "  ")
    yield f"{indent}$ENDDO {format_expression(node.condition)}"


def _print_repeat(node: Repeat, indent: str) -> Iterator[str]:
    yield f"{indent}{format_head(node.head)}$REPEAT"
    yield from _body(node.body, indent + "  ")
    yield f"{indent}$UNTIL {format_expression(node.condition)}"


def _print_switch(node: Switch, indent: str) -> Iterator[str]:
    yield f"{indent}{format_head(node.head)}$SWITCH {format_expression(node.subject)}"
    for case in node.cases:
        yield from _print_case(case, indent + "  ")
    yield f"{indent}$ENDSWITCH"


def _print_case(case: Case, indent: str) -> Iterator[str]:
    word = "$DEFAULT" if case.value is None else f"$CASE {format_expression(case.value)}"
    yield f"{indent}{format_head(case.head)}{word}"
    yield from _body(case.body, indent + "  ")


def _print_cycle(node: RealtimeCycle, indent: str) -> Iterator[str]:
    definition = "DEF " if node.definition_only else ""
    keywords = _optional_items(node.keywords)
    yield f"{indent}{format_head(node.head)}#RT CYCLE {definition}{keywords}".rstrip()
    yield from _body(node.body, indent + "  ")
    yield f"{indent}#RT CYCLE END"


def _print_declarations(node: VariableDeclarations, indent: str) -> Iterator[str]:
    yield f"{indent}{format_head(node.head)}#VAR"
    for declaration in node.declarations:
        yield f"{indent}  {_format_declaration(declaration)}"
    yield f"{indent}#ENDVAR"


def _format_declaration(node: Declaration) -> str:
    text = format_head(node.head) + format_expression(node.variable)
    if node.type_name is not None:
        text += f" : {node.type_name}"
    if node.size is not None:
        text += f"[{format_expression(node.size)}]"
    return text if node.initial is None else f"{text} = {format_expression(node.initial)}"


_STRUCTURES: dict[type[Statement], Callable[[Any, str], Iterator[str]]] = {
    If: _print_if,
    For: _print_for,
    While: _print_while,
    Do: _print_do,
    Repeat: _print_repeat,
    Switch: _print_switch,
    RealtimeCycle: _print_cycle,
    RealtimeLoop: _print_realtime_loop,
    VariableDeclarations: _print_declarations,
}
