# SPDX-License-Identifier: MIT
"""Tokens -> declarations of the tree: POUs, interfaces, types, lists of variables, tasks.

In: the tokens of plain text (ST-105), or of a declaration in an XML file (ST-102). Out: nodes of
``tree.py``. After a syntax error reading continues at the next declared variable or object.
"""

from __future__ import annotations

import re

from nctakt.base.diagnostics import Text
from nctakt.messages.plcs.st_text import (
    END_KEYWORD_MISSING,
    GENERIC_REFUSED,
    TASK_TIME_UNKNOWN,
    TOKEN_EXPECTED,
    UNEXPECTED_TOKEN,
    VARIABLES_EXPECTED,
)
from nctakt.st.parse.lexer import ADDRESS, END, NAME
from nctakt.st.parse.literals import duration_ns
from nctakt.st.parse.parser import MEMBER_WORDS, StatementParser, SyntaxFaultError
from nctakt.st.tree import (
    Argument,
    ArrayNode,
    Declaration,
    EnumItem,
    EnumNode,
    GlobalListNode,
    Header,
    InterfaceNode,
    MethodNode,
    NamedType,
    PointerNode,
    PouNode,
    PropertyNode,
    StringNode,
    StructNode,
    SubrangeNode,
    TaskNode,
    TypeDeclaration,
    TypeExpression,
    TypeNode,
    VariableBlock,
    VariableNode,
)
from nctakt.st.types import Access, Expression, Kind

_VAR_KEYWORDS = frozenset(
    """VAR VAR_INPUT VAR_OUTPUT VAR_IN_OUT VAR_TEMP VAR_STAT VAR_INST VAR_GLOBAL VAR_EXTERNAL
    VAR_CONFIG VAR_ACCESS""".split()
)
_GENERIC = "VAR_GENERIC"
_QUALIFIERS = frozenset(("CONSTANT", "RETAIN", "PERSISTENT", "NON_RETAIN"))
_POU_KINDS = {kind.value: kind for kind in Kind}
_ACCESS = {access.value: access for access in Access}
_POINTERS = {"POINTER": False, "REFERENCE": True}
_STRINGS = {"STRING": False, "WSTRING": True}
#: Where reading continues after a fault among declarations.
_OBJECTS = frozenset(
    (*_POU_KINDS, "INTERFACE", "TYPE", "VAR_GLOBAL", "CONFIGURATION", END)
)  # fmt: skip

_INTERVAL = re.compile(r"(?:L?TIME|L?T)#", re.IGNORECASE)


class DeclarationParser(StatementParser):
    """Reads declarations, with the bodies that follow them in plain text."""

    # --- plain text -------------------------------------------------------------------------------

    def file(self) -> list[Declaration]:
        """Read all of a plain text."""
        found: list[Declaration] = []
        while self.kinds[self.index] != END:
            kind = self.kinds[self.index]
            try:
                if kind in _POU_KINDS:
                    found.append(self.pou(has_body=True))
                elif kind == "INTERFACE":
                    found.append(self.interface(is_plain=True))
                elif kind == "TYPE":
                    found += self.types()
                elif kind == "VAR_GLOBAL":
                    attributes = self.attributes.get(self.index, {})
                    block = self._block()
                    found.append(GlobalListNode(block.start, block.end, "", [block], attributes))
                elif kind == "CONFIGURATION":
                    found += self._configuration()
                elif kind == ";":
                    self.index += 1
                else:
                    self.fail(UNEXPECTED_TOKEN, found=self.texts[self.index])
            except SyntaxFaultError:
                self._depth = 0
                if self.kinds[self.index] != END:
                    self.index += 1
                while self.kinds[self.index] not in _OBJECTS:
                    self.index += 1
        return found

    def pou(self, *, has_body: bool) -> PouNode:
        """Read a POU: its declaration, and its body in plain text."""
        attributes = self.attributes.get(self.index, {})
        kind = _POU_KINDS[self.kinds[self.index]]
        self.index += 1
        access, words = self._modifiers()
        attributes = attributes or self.attributes.get(self.index, {})
        start = self.start
        pou = PouNode(start, start + 1, self.name(), attributes, access, kind=kind)
        pou.end = self.end
        pou.is_abstract, pou.is_final = "ABSTRACT" in words, "FINAL" in words
        self._relations(pou)
        pou.variables = self.blocks()
        if pou.variables and _GENERIC in pou.variables[-1].qualifiers:
            self._relations(pou)  # VAR_GENERIC comes before them
            pou.variables += self.blocks()
        if has_body:
            self._members(pou)
            pou.body = self.statements()
            self._members(pou)
            self._end_object(f"END_{kind.value}", start)
        return pou

    def _end_object(self, keyword: str, start: int) -> None:
        """Read the keyword that ends an object in plain text."""
        if not self.accept(keyword):
            found = self.texts[self.index] or "–"
            line = self.reporter.sources.line_number(start)
            self.report(END_KEYWORD_MISSING, keyword=keyword, line=line, found=found)
            while self.kinds[self.index] not in _OBJECTS:
                self.index += 1
                if self.accept(keyword):
                    break
        self.accept(";")

    def _members(self, owner: PouNode | InterfaceNode) -> None:
        """Read methods, properties and actions of plain text."""
        is_abstract = isinstance(owner, InterfaceNode)
        while self.kinds[self.index] == NAME and self.word() in MEMBER_WORDS:
            if self.kinds[self.index + 1] != NAME:
                return
            word = self.word()
            if word == "METHOD":
                owner.methods.append(self.method(has_body=True, is_abstract=is_abstract))
            elif word == "PROPERTY":
                owner.properties.append(self.property(is_plain=True))
            elif isinstance(owner, PouNode):
                owner.methods.append(self._action())
            else:
                self.fail(UNEXPECTED_TOKEN, found=word)

    def _action(self) -> MethodNode:
        attributes = self.attributes.get(self.index, {})
        self.index += 1
        start = self.start
        action = MethodNode(start, start + 1, self.name(), attributes, is_action=True)
        action.end = self.end
        self.accept(":")
        action.body = self.statements()
        self._end_object("END_ACTION", start)
        return action

    def _relations(self, pou: PouNode) -> None:
        """Read base and interfaces of a unit, and the type of its result."""
        while True:
            if self.accept_word("EXTENDS"):
                pou.base = self._named_type()
            elif self.accept_word("IMPLEMENTS"):
                pou.interfaces = self._names()
            elif self.accept(":"):
                pou.result = self.type()
            else:
                break
        self.accept(";")

    def method(self, *, has_body: bool, is_abstract: bool = False) -> MethodNode:
        """Read the declaration of a method, in plain text with its body."""
        attributes = self.attributes.get(self.index, {})
        self.index += 1
        method = MethodNode(0, 0, "", attributes)
        self._header(method)
        if self.accept(":"):
            method.result = self.type()
        self.accept(";")
        method.variables = self.blocks()
        if has_body and not (is_abstract and self.kinds[self.index] != "END_METHOD"):
            method.body = self.statements()
            self._end_object("END_METHOD", method.start)
        return method

    def property(self, *, is_plain: bool) -> PropertyNode:
        """Read the declaration of a property, in plain text with its accessors."""
        attributes = self.attributes.get(self.index, {})
        self.index += 1
        node = PropertyNode(0, 0, "", attributes)
        self._header(node)
        self.expect(":")
        node.result = self.type()
        self.accept(";")
        if not is_plain:
            return node
        self.blocks()
        while self.kinds[self.index] == NAME and self.word() in ("GET", "SET"):
            accessor = self.accessor()
            accessor.body = self.statements()
            self._end_object(f"END_{accessor.name.upper()}", accessor.start)
            if accessor.name.upper() == "GET":
                node.get = accessor
            else:
                node.set = accessor
        self._end_object("END_PROPERTY", node.start)
        return node

    def accessor(self) -> MethodNode:
        """Read ``GET`` or ``SET`` with its variables."""
        start = self.start
        name = self.name().capitalize()
        accessor = MethodNode(start, self.end, name)
        accessor.variables = self.blocks()
        return accessor

    def accessor_access(self) -> Access:
        """Read the modifier of an accessor in an XML file, which is alone there."""
        access = Access.PUBLIC
        while self.kinds[self.index] == NAME and self.word() in (*_ACCESS, "FINAL", "ABSTRACT"):
            access = _ACCESS.get(self.word(), access)
            self.index += 1
        return access

    def _header(self, node: Header) -> None:
        """Read modifiers and name of a method or property."""
        node.access, words = self._modifiers()
        node.is_abstract, node.is_final = "ABSTRACT" in words, "FINAL" in words
        node.attributes = node.attributes or self.attributes.get(self.index, {})
        node.start = self.start
        node.name = self.name()
        node.end = self.end

    def _modifiers(self) -> tuple[Access, list[str]]:
        """Read PUBLIC …, ABSTRACT, FINAL; a word is a modifier only if a name follows."""
        access, words = Access.PUBLIC, []
        while self.kinds[self.index] == NAME and self.kinds[self.index + 1] == NAME:
            word = self.word()
            if word in _ACCESS:
                access = _ACCESS[word]
            elif word in ("ABSTRACT", "FINAL"):
                words.append(word)
            else:
                break
            self.index += 1
        return access, words

    def interface(self, *, is_plain: bool) -> InterfaceNode:
        """Read an interface, in plain text with its members."""
        attributes = self.attributes.get(self.index, {})
        self.index += 1
        access, _ = self._modifiers()
        start = self.start
        node = InterfaceNode(start, start + 1, self.name(), attributes, access)
        node.end = self.end
        if self.accept_word("EXTENDS"):
            node.bases = self._names()
        self.accept(";")
        if is_plain:
            self._members(node)
            self._end_object("END_INTERFACE", start)
        return node

    def _names(self) -> list[NamedType]:
        names = [self._named_type()]
        while self.accept(","):
            names.append(self._named_type())
        return names

    def end_of_declaration(self, keyword: str = "") -> None:
        """Check that nothing but an END keyword follows the declaration in an XML file."""
        while self.kinds[self.index] == ";" or (keyword and self.kinds[self.index] == keyword):
            self.index += 1
        if self.kinds[self.index] != END:
            self.report(VARIABLES_EXPECTED, found=self.texts[self.index])

    # --- tasks ------------------------------------------------------------------------------------

    def _configuration(self) -> list[Declaration]:
        """Read CONFIGURATION: its lists of variables, its tasks with their programs."""
        found: list[Declaration] = []
        tasks: dict[str, TaskNode] = {}
        while not self.accept("END_CONFIGURATION"):
            if self.kinds[self.index] == "VAR_GLOBAL":
                block = self._block()
                found.append(GlobalListNode(block.start, block.end, "", [block]))
            elif self.accept_word("TASK"):
                task = self._task()
                tasks[task.name.lower()] = task
            elif self.accept("PROGRAM"):
                self._program(tasks)
            elif self.kinds[self.index] == END:
                self.fail(TOKEN_EXPECTED, expected="END_CONFIGURATION", found="–")
            else:
                self.index += 1  # names of configuration and resource, ON, END_RESOURCE
        return [*found, *tasks.values()]

    def _task(self) -> TaskNode:
        start = self.start
        task = TaskNode(start, start + 1, self.name(), 0, 0, [])
        task.end = self.end
        if not self.accept("("):
            return task
        for argument in self.arguments():
            piece = self.reporter.sources.piece_of(argument.start)
            text = "" if piece is None else piece.text[argument.start - piece.base :]
            text = text[: argument.end - argument.start].partition(":=")[2].strip()
            if argument.name.upper() == "PRIORITY" and text.isdecimal():
                task.priority = int(text[:6])
            elif argument.name.upper() == "INTERVAL":
                duration = duration_ns(text.partition("#")[2]) if _INTERVAL.match(text) else None
                if duration is None:
                    self.reporter.report(TASK_TIME_UNKNOWN, argument.start, argument.end, text=text)
                else:
                    task.cycle_us = duration // 1000
        self.accept(";")
        return task

    def _program(self, tasks: dict[str, TaskNode]) -> None:
        """Read ``PROGRAM instance WITH task : type``."""
        name = self.name()
        task = self.name() if self.accept_word("WITH") else ""
        if self.accept(":"):
            name = self.name()
        if task.lower() in tasks:
            tasks[task.lower()].programs.append(name)
        self.accept(";")

    # --- variables --------------------------------------------------------------------------------

    def blocks(self) -> list[VariableBlock]:
        """Read all VAR … END_VAR that follow each other."""
        found = []
        while self.kinds[self.index] in _VAR_KEYWORDS or self.word() == _GENERIC:
            found.append(self._block())
        return found

    def _block(self) -> VariableBlock:
        start, keyword = self.start, self.kinds[self.index]
        qualifiers = set()
        if self.word() == _GENERIC:
            self.report(GENERIC_REFUSED)
            keyword = "VAR"
            qualifiers.add(_GENERIC)
        self.index += 1
        while self.kinds[self.index] == NAME and self.word() in _QUALIFIERS:
            if self.kinds[self.index + 1] in (":", ","):
                break
            qualifiers.add(self.word())
            self.index += 1
        block = VariableBlock(start, self.end, keyword, frozenset(qualifiers), [])
        self._variables(block.variables, "END_VAR", start)
        self.accept(";")
        return block

    def _variables(self, found: list[VariableNode], end: str, start: int) -> None:
        """Read variables up to ``end``."""
        while not self.accept(end):
            kind = self.kinds[self.index]
            if kind in _OBJECTS or kind in _VAR_KEYWORDS or kind.startswith("END_"):
                line = self.reporter.sources.line_number(start)
                text = self.texts[self.index] or "–"
                self.report(END_KEYWORD_MISSING, keyword=end, line=line, found=text)
                return
            try:
                found += self._variable()
            except SyntaxFaultError:
                self._depth = 0
                while self.kinds[self.index] not in (";", end, *_OBJECTS, *_VAR_KEYWORDS):
                    self.index += 1
                self.accept(";")

    def _variable(self) -> list[VariableNode]:
        """Read a declaration with its semicolon: ``a, b AT %I* : TYPE := value;``."""
        if self.accept(";"):
            return []
        attributes = self.attributes.get(self.index, {})
        names = [self._variable_name()]
        while self.accept(","):
            attributes |= self.attributes.get(self.index, {})
            names.append(self._variable_name())
        address = ""
        if self.accept_word("AT"):
            if self.kinds[self.index] != ADDRESS:
                self.fail(TOKEN_EXPECTED, expected="%I*", found=self._found())
            address = self.texts[self.index].upper()
            self.index += 1
        self.expect(":")
        kind = self.type()
        node = VariableNode(0, 0, "", kind)
        if isinstance(kind, NamedType) and self.accept("("):
            node.arguments = self.arguments()
        elif isinstance(kind, ArrayNode) and self.kinds[self.index] in ("[", "("):
            node.element_arguments = self._element_arguments()
        if self.accept(":="):
            node.initial = self.initial_value()
        elif self.kinds[self.index] == NAME and self.word() == "REF" and self.word(1) == "=":
            self.index += 2
            node.initial, node.is_bound = self.initial_value(), True
        if self.kinds[self.index] == ";":
            self.index += 1
        elif self.kinds[self.index] in ("END_VAR", "END_STRUCT", "END_UNION"):
            self.report(TOKEN_EXPECTED, expected=";", found=self._found())
        else:
            self.fail(TOKEN_EXPECTED, expected=";", found=self._found())
        return [
            VariableNode(
                start,
                start + len(name),
                name,
                kind,
                node.initial,
                node.arguments,
                node.element_arguments,
                node.is_bound,
                address,
                attributes,
            )
            for name, start in names
        ]

    def _variable_name(self) -> tuple[str, int]:
        start = self.start
        return self.name(), start

    def _element_arguments(self) -> list[list[Argument]]:
        """Read ``[(a := 1), (a := 2)]`` after the type of an array of blocks."""
        if self.accept("("):
            return [self.arguments()]
        self.index += 1
        found: list[list[Argument]] = []
        while not self.accept("]"):
            self.expect("(")
            found.append(self.arguments())
            if not self.accept(","):
                self.expect("]")
                break
        return found

    # --- types ------------------------------------------------------------------------------------

    def types(self) -> list[TypeDeclaration]:
        """Read ``TYPE … END_TYPE`` with one type or several."""
        attributes = self.attributes.get(self.index, {})
        begin = self.start
        self.index += 1
        self._modifiers()
        found: list[TypeDeclaration] = []
        while not self.accept("END_TYPE"):
            if self.accept(";"):
                continue
            if self.kinds[self.index] in _OBJECTS:
                line = self.reporter.sources.line_number(begin)
                text = self.texts[self.index] or "–"
                self.report(END_KEYWORD_MISSING, keyword="END_TYPE", line=line, found=text)
                break
            start = self.start
            attributes = attributes or self.attributes.get(self.index, {})
            name = self.name()
            base = self._named_type() if self.accept_word("EXTENDS") else None
            self.expect(":")
            attributes = attributes or self.attributes.get(self.index, {})
            kind = self.type()
            initial = self.initial_value() if self.accept(":=") else None
            end = start + len(name)
            found.append(TypeDeclaration(start, end, name, kind, base, initial, attributes))
            attributes = {}
        return found

    def type(self) -> TypeNode:
        """Read a type."""
        kind, start, word = self.kinds[self.index], self.start, self.word()
        if kind in ("STRUCT", "UNION"):
            self.index += 1
            struct = StructNode(start, self.end, [], kind == "UNION")
            self._enter()
            self._variables(struct.members, f"END_{kind}", start)
            self._depth -= 1
            return struct
        if kind == "(":
            return self._enumeration(start)
        if kind != NAME:
            self.fail(TOKEN_EXPECTED, expected=_TYPE, found=self._found())
        if word == "ARRAY" and self.kinds[self.index + 1] == "[":
            return self._array(start)
        if word in _POINTERS and self.kinds[self.index + 1] == "TO":
            self.index += 2
            self._enter()
            target = self.type()
            self._depth -= 1
            return PointerNode(start, target.end, target, _POINTERS[word])
        if word in _STRINGS:
            self.index += 1
            length = None
            if (opening := self.kinds[self.index]) in ("(", "["):
                self.index += 1
                length = self.expression()
                self.expect(")" if opening == "(" else "]")
            return StringNode(start, self.end, _STRINGS[word], length)
        named = self._named_type()
        if self.kinds[self.index] == "<":
            self._generic()
        if self.kinds[self.index] == "(" and self._is_subrange():
            self.index += 1
            low = self.expression()
            self.expect("..")
            high = self.expression()
            self.expect(")")
            return SubrangeNode(start, self.end, named, low, high)
        return named

    def _type_expression(self) -> Expression:
        node = self.type()
        return TypeExpression(node.start, node.end, node)

    def _named_type(self) -> NamedType:
        start = self.start
        name = self.name()
        while self.kinds[self.index] == "." and self.kinds[self.index + 1] == NAME:
            name += f".{self.texts[self.index + 1]}"
            self.index += 2
        return NamedType(start, self.end, name)

    def _generic(self) -> None:
        """Refuse ``FB<6>``, and read on after it."""
        self.report(GENERIC_REFUSED)
        while self.kinds[self.index] not in (">", ";", END):
            self.index += 1
        self.accept(">")

    def _is_subrange(self) -> bool:
        """Whether the bracket after a type holds a range, not arguments of FB_init."""
        depth, index = 0, self.index
        while (kind := self.kinds[index]) not in (END, ";", ":="):
            if kind == "(":
                depth += 1
            elif kind == ")":
                depth -= 1
                if depth == 0:
                    return False
            elif kind == ".." and depth == 1:
                return True
            index += 1
        return False

    def _array(self, start: int) -> ArrayNode:
        self.index += 2
        bounds: list[tuple[Expression, Expression] | None] = []
        while True:
            if self.accept("*"):
                bounds.append(None)
            else:
                low = self.expression()
                self.expect("..")
                bounds.append((low, self.expression()))
            if not self.accept(","):
                break
        self.expect("]")
        self.expect("OF")
        self._enter()
        element = self.type()
        self._depth -= 1
        return ArrayNode(start, element.end, bounds, element)

    def _enumeration(self, start: int) -> EnumNode:
        self.index += 1
        items: list[EnumItem] = []
        while not self.accept(")"):
            begin = self.start
            name = self.name()
            end = self.end
            value = self.expression() if self.accept(":=") else None
            items.append(EnumItem(begin, end, name, value))
            if not self.accept(","):
                self.expect(")")
                break
        base = self._named_type() if self.kinds[self.index] == NAME else None
        return EnumNode(start, self.end, items, base)


_TYPE = Text("type", "Typ")
