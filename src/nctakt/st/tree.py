# SPDX-License-Identifier: MIT
"""The syntax tree of Structured Text: declarations, types as written, statements, expressions.

The parser makes it, the checker writes the meaning of expressions into it: ``type`` and ``value``
(``types.Expression``), ``target`` of names, members and calls. Names are as written; they are
compared in lower case.

The meaning of a name (``target``): a ``Variable`` (``Storage.INSTANCE``: of THIS;
``Section.IN_OUT`` and references are followed by themselves), a ``Property`` of THIS, an
``EnumValue``, a ``Pou``, a ``Method`` of THIS, a ``GlobalList``, a ``Type``, or a ``Library``. The
same for a ``Member``, with ``base`` as the instance or structure; if ``base`` is only a qualifier
(list, enumeration, library), ``target`` is everything.
"""

from __future__ import annotations

import enum

from nctakt.base.dataclass import dataclass, field
from nctakt.st.types import (
    Access,
    Callable,
    EnumValue,
    Expression,
    Kind,
    Method,
    Node,
    Pou,
    Property,
    Statement,
    Type,
    Variable,
)

# --- expressions ---------------------------------------------------------------------------------


@dataclass(slots=True, eq=False)
class GlobalList:
    """A list of global variables; ``name`` is "" for lists of plain text."""

    name: str
    variables: dict[str, Variable] = field(default_factory=dict)
    is_qualified_only: bool = False
    library: str = ""


@dataclass(slots=True, eq=False)
class Library:
    """A library that is known by name, as the first part of a path."""

    name: str


Target = Variable | Property | EnumValue | Pou | Method | GlobalList | Type | Library


@dataclass(slots=True, eq=False)
class Literal(Expression):
    """A literal as written: ``prefix`` is the type before ``#`` in upper case, or ""."""

    text: str
    prefix: str = ""


@dataclass(slots=True, eq=False)
class Name(Expression):
    """A name; ``is_global`` for ``.name``."""

    name: str
    is_global: bool = False
    target: Target | None = None


@dataclass(slots=True, eq=False)
class Address(Expression):
    """A fixed address in code: ``%IX0.0``."""

    text: str


@dataclass(slots=True, eq=False)
class This(Expression):
    """``THIS``: the pointer to the instance; ``THIS^`` is a ``Dereference`` of it."""


@dataclass(slots=True, eq=False)
class Super(Expression):
    """``SUPER``: as ``THIS``, but calls by ``SUPER^`` are bound to the base's methods."""


@dataclass(slots=True, eq=False)
class Member(Expression):
    """``base.name``; of bit access by a constant (``x.cBit``) ``bit`` is its number, else −1."""

    base: Expression
    name: str
    target: Target | None = None
    bit: int = -1


@dataclass(slots=True, eq=False)
class Bit(Expression):
    """``base.3``."""

    base: Expression
    number: int


@dataclass(slots=True, eq=False)
class Index(Expression):
    """``base[i, j]``: of an array, a string (bytes from 0) or a pointer (elements)."""

    base: Expression
    indices: list[Expression]


@dataclass(slots=True, eq=False)
class Dereference(Expression):
    """``base^``."""

    base: Expression


class Operator(enum.Enum):
    """Operators; the value is how they are written."""

    OR = "OR"
    OR_ELSE = "OR_ELSE"
    XOR = "XOR"
    AND = "AND"
    AND_THEN = "AND_THEN"
    EQUAL = "="
    UNEQUAL = "<>"
    LESS = "<"
    GREATER = ">"
    LESS_EQUAL = "<="
    GREATER_EQUAL = ">="
    ADD = "+"
    SUBTRACT = "-"
    MULTIPLY = "*"
    DIVIDE = "/"
    MOD = "MOD"
    POWER = "**"
    NOT = "NOT"
    NEGATE = "unary -"
    PLUS = "unary +"


@dataclass(slots=True, eq=False)
class Unary(Expression):
    """NOT, minus or plus before an operand."""

    operator: Operator
    operand: Expression


@dataclass(slots=True, eq=False)
class Binary(Expression):
    """Two operands; ``operand_type`` is the type both are converted to before (ST-302 … 304).

    For comparisons ``type`` is BOOL; for a signed and an unsigned whole number ``operand_type`` is
    ``None``: their values are compared.
    """

    operator: Operator
    left: Expression
    right: Expression
    operand_type: Type | None = None


@dataclass(slots=True, eq=False)
class Argument(Node):
    """An argument as written: ``name := value``, ``name => value`` or ``value`` (``name`` "")."""

    name: str
    value: Expression | None
    is_output: bool = False


class CallKind(enum.Enum):
    """Kinds of calls."""

    FUNCTION = "function"  # ``target`` is a Pou
    METHOD = "method"  # ``target`` is a Method, ``instance`` is not None
    BLOCK = "block"  # the body of an instance or program: ``target`` is its Pou
    BUILT_IN = "built-in"  # ``function`` is the name in upper case: ADR, SIZEOF, MIN, SEL …
    CONVERSION = "conversion"  # argument 0 to ``type``; ``function`` TO, TRUNC or TRUNC_INT


@dataclass(slots=True, eq=False)
class Call(Expression):
    """A call.

    Set by the checker: ``kind``, ``target``; ``instance`` is the instance of the call (``None`` for
    functions and programs; a ``This`` if a method of the same instance is called without prefix);
    ``is_virtual`` is False for ``SUPER^``. ``bound`` has the given arguments in the order written:
    parameter and expression; outputs are the places they go to, parameters of VAR_IN_OUT are passed
    by address. Inputs left out have their initial values (functions and methods) or keep their
    values (blocks). Built-ins and conversions have ``operands`` instead.
    """

    callee: Expression
    arguments: list[Argument]
    kind: CallKind | None = None
    target: Callable | None = None
    function: str = ""
    instance: Expression | None = None
    is_virtual: bool = True
    bound: list[tuple[Variable, Expression]] = field(default_factory=list)
    operands: list[Expression] = field(default_factory=list)


@dataclass(slots=True, eq=False)
class AssignmentExpression(Expression):
    """``b := c`` as a value: in ``a := b := c``."""

    target: Expression
    assigned: Expression


@dataclass(slots=True, eq=False)
class Repetition(Node):
    """``3(0)`` in an array's initial value."""

    count: Expression
    values: list[Expression]
    number: int = 0  # the count, set by the checker


@dataclass(slots=True, eq=False)
class ArrayInitial(Expression):
    """``[1, 2, 3(0)]`` as an initial value."""

    items: list[Expression | Repetition]


@dataclass(slots=True, eq=False)
class StructInitial(Expression):
    """``(a := 1, b := 2)`` as an initial value; ``bound`` is set by the checker."""

    arguments: list[Argument]
    bound: list[tuple[Variable, Expression]] = field(default_factory=list)


@dataclass(slots=True, eq=False)
class TypeNode(Node):
    """A type as written."""


@dataclass(slots=True, eq=False)
class TypeExpression(Expression):
    """A type as an operand: ``SIZEOF(POINTER TO INT)``; its type is ``type``."""

    node: TypeNode


# --- statements ----------------------------------------------------------------------------------


@dataclass(slots=True, eq=False)
class Assignment(Statement):
    """``target := value``; ``operator`` is ``:=``, ``S=``, ``R=`` or ``REF=``.

    Where the target is a property, it is a call of its Set.
    """

    target: Expression
    operator: str
    value: Expression


@dataclass(slots=True, eq=False)
class CallStatement(Statement):
    """A call as a statement."""

    call: Call


@dataclass(slots=True, eq=False)
class Evaluation(Statement):
    """A path alone, which reads a property or the result of a call: its calls have effects."""

    expression: Expression


@dataclass(slots=True, eq=False)
class Branch(Node):
    """A condition of IF or ELSIF with its statements."""

    condition: Expression
    body: list[Statement]


@dataclass(slots=True, eq=False)
class If(Statement):
    """IF … ELSIF … ELSE … END_IF; ``otherwise`` is empty without ELSE."""

    branches: list[Branch]
    otherwise: list[Statement]


@dataclass(slots=True, eq=False)
class Label(Node):
    """A label of CASE: ``low`` alone or ``low..high``; the numbers are set by the checker."""

    low: Expression
    high: Expression | None
    first: int = 0
    last: int = 0


@dataclass(slots=True, eq=False)
class CaseBranch(Node):
    """Labels of CASE with their statements."""

    labels: list[Label]
    body: list[Statement]


@dataclass(slots=True, eq=False)
class Case(Statement):
    """CASE … OF … END_CASE."""

    selector: Expression
    branches: list[CaseBranch]
    otherwise: list[Statement]


@dataclass(slots=True, eq=False)
class For(Statement):
    """FOR … TO … BY … DO … END_FOR; limits are evaluated once (ST-512)."""

    counter: Expression
    first: Expression
    last: Expression
    step: Expression | None
    body: list[Statement]


@dataclass(slots=True, eq=False)
class While(Statement):
    """WHILE … DO … END_WHILE."""

    condition: Expression
    body: list[Statement]


@dataclass(slots=True, eq=False)
class Repeat(Statement):
    """REPEAT … UNTIL … END_REPEAT."""

    body: list[Statement]
    condition: Expression


@dataclass(slots=True, eq=False)
class Exit(Statement):
    """EXIT."""


@dataclass(slots=True, eq=False)
class Continue(Statement):
    """CONTINUE."""


@dataclass(slots=True, eq=False)
class Return(Statement):
    """RETURN."""


# --- declarations --------------------------------------------------------------------------------


@dataclass(slots=True, eq=False)
class NamedType(TypeNode):
    """A type by its name; ``name`` with its library or list: ``Tc2_MC2.AXIS_REF``."""

    name: str


@dataclass(slots=True, eq=False)
class StringNode(TypeNode):
    """STRING or WSTRING with its length in brackets, if any."""

    is_wide: bool
    length: Expression | None


@dataclass(slots=True, eq=False)
class ArrayNode(TypeNode):
    """ARRAY[low..high, …] OF element; a bound that is ``None`` is ``*``."""

    bounds: list[tuple[Expression, Expression] | None]
    element: TypeNode


@dataclass(slots=True, eq=False)
class PointerNode(TypeNode):
    """POINTER TO or REFERENCE TO."""

    target: TypeNode
    is_reference: bool


@dataclass(slots=True, eq=False)
class SubrangeNode(TypeNode):
    """``INT(1..5)``."""

    base: NamedType
    low: Expression
    high: Expression


@dataclass(slots=True, eq=False)
class EnumItem(Node):
    """A value of an enumeration as written."""

    name: str
    value: Expression | None


@dataclass(slots=True, eq=False)
class EnumNode(TypeNode):
    """``(A, B := 5) BYTE``."""

    items: list[EnumItem]
    base: NamedType | None


@dataclass(slots=True, eq=False)
class StructNode(TypeNode):
    """STRUCT … END_STRUCT, or UNION."""

    members: list[VariableNode]
    is_union: bool


@dataclass(slots=True, eq=False)
class VariableNode(Node):
    """A declared variable; ``start`` … ``end`` are those of its name.

    ``arguments``: ``None`` without brackets after the type; ``element_arguments``: those of each
    element of an array of blocks.
    """

    name: str
    type: TypeNode
    initial: Expression | None = None
    arguments: list[Argument] | None = None
    element_arguments: list[list[Argument]] = field(default_factory=list)
    is_bound: bool = False  # REF= instead of :=
    address: str = ""
    attributes: dict[str, str] = field(default_factory=dict)


@dataclass(slots=True, eq=False)
class VariableBlock(Node):
    """VAR … END_VAR: ``keyword`` (VAR_INPUT …) and ``qualifiers`` (CONSTANT …) in upper case."""

    keyword: str
    qualifiers: frozenset[str]
    variables: list[VariableNode]


@dataclass(slots=True, eq=False)
class Header(Node):
    """The head of methods, properties, POUs and interfaces; the span is that of the name."""

    name: str
    attributes: dict[str, str] = field(default_factory=dict)
    access: Access = Access.PUBLIC
    is_abstract: bool = False
    is_final: bool = False
    result: TypeNode | None = None
    variables: list[VariableBlock] = field(default_factory=list)
    body: list[Statement] = field(default_factory=list)


@dataclass(slots=True, eq=False)
class MethodNode(Header):
    """A method, an action, or an accessor of a property; refused: its language is not ST."""

    is_action: bool = False
    is_refused: bool = False


@dataclass(slots=True, eq=False)
class PropertyNode(Header):
    """A property; its type is ``result``."""

    get: MethodNode | None = None
    set: MethodNode | None = None


@dataclass(slots=True, eq=False)
class PouNode(Header):
    """A program, function block or function. ``language`` is ST, else that which is refused."""

    kind: Kind = Kind.PROGRAM
    base: NamedType | None = None
    interfaces: list[NamedType] = field(default_factory=list)
    methods: list[MethodNode] = field(default_factory=list)
    properties: list[PropertyNode] = field(default_factory=list)
    language: str = "ST"


@dataclass(slots=True, eq=False)
class InterfaceNode(Header):
    """An interface."""

    bases: list[NamedType] = field(default_factory=list)
    methods: list[MethodNode] = field(default_factory=list)
    properties: list[PropertyNode] = field(default_factory=list)


@dataclass(slots=True, eq=False)
class TypeDeclaration(Node):
    """``TYPE name : … END_TYPE``; the span is that of the name."""

    name: str
    type: TypeNode
    base: NamedType | None = None
    initial: Expression | None = None
    attributes: dict[str, str] = field(default_factory=dict)


@dataclass(slots=True, eq=False)
class GlobalListNode(Node):
    """A list of global variables: the name of its file, "" in plain text."""

    name: str
    blocks: list[VariableBlock]
    attributes: dict[str, str] = field(default_factory=dict)


@dataclass(slots=True, eq=False)
class TaskNode(Node):
    """A task: the programs that it calls, in order. ``cycle_us`` 0: not given."""

    name: str
    cycle_us: int
    priority: int
    programs: list[str]


Declaration = PouNode | InterfaceNode | TypeDeclaration | GlobalListNode | TaskNode
