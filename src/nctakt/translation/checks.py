# SPDX-License-Identifier: MIT
"""The functions by which a project checks indices, divisors, ranges and pointers (ST-560)."""

from __future__ import annotations

from nctakt.st import tree
from nctakt.st.types import Elementary, Expression, Family, PointerType, Pou, Type
from nctakt.translation.body import Body

#: The names of all such functions; they do not check themselves.
CHECK_FUNCTIONS = frozenset(
    """checkbounds checkdivdint checkdivlint checkdivreal checkdivlreal checkrangesigned
    checkrangeunsigned checklrangesigned checklrangeunsigned checkpointer""".split()
)
_NO_CHECK = "no_check"


class CheckFunctions(Body):
    """Calls of the project's check functions."""

    def check_function(self, name: str) -> Pou | None:
        """Return a check function of the project, where this body asks for it."""
        found = self.project.own_function(name)
        owner = self.pou or self.called
        if found is None or owner.name.lower() in CHECK_FUNCTIONS or not isinstance(owner, Pou):
            return None
        return None if owner.library or _NO_CHECK in owner.attributes else found

    def checked_value(self, name: str, value: Expression, *others: int) -> Expression:
        """Return the call of a check function with a value, or the value itself without one."""
        found = self.check_function(name)
        if found is None or len(found.inputs) != 1 + len(others):
            return value
        start, end = value.start, value.end
        callee = tree.Name(start, end, found.name, target=found)
        call = tree.Call(start, end, callee, [])
        call.kind, call.target = tree.CallKind.FUNCTION, found
        call.type = found.result.type if found.result is not None else None
        call.bound = [(found.inputs[0], value)]
        for parameter, number in zip(found.inputs[1:], others, strict=True):
            literal = tree.Literal(start, end, str(number), type=parameter.type, value=number)
            call.bound.append((parameter, literal))
        return call

    def checked_divisor(self, divisor: Expression, found: Type) -> Expression:
        """Return a divisor as the project's function gives it."""
        if not isinstance(found, Elementary) or divisor.value is not None:
            return divisor
        if found.family is Family.REAL:
            return self.checked_value(f"checkdiv{'lreal' if found.size > 4 else 'real'}", divisor)
        return self.checked_value(f"checkdiv{'lint' if found.size > 4 else 'dint'}", divisor)

    def checked_range(self, value: Expression, target: Type) -> Expression:
        """Return a value that goes into a subrange as the project's function gives it."""
        if not isinstance(target, Elementary) or not target.is_subrange:
            return value
        kind = "signed" if target.is_signed else "unsigned"
        name = f"check{'l' if target.size > 4 else ''}range{kind}"
        return self.checked_value(name, value, target.low, target.high)

    def checked_pointer(self, pointer: Expression, is_written: bool) -> Expression:
        """Return a pointer that is dereferenced as the project's function gives it."""
        found = pointer.type
        if not isinstance(found, PointerType) or found.target is None:
            return pointer
        size, align = found.target.size, found.target.align
        return self.checked_value("checkpointer", pointer, size, align, is_written)


def written_pointer(target: Expression) -> Expression | None:
    """Return the dereference that an assignment writes through."""
    while isinstance(target, tree.Member | tree.Index | tree.Bit):
        target = target.base
    return target if isinstance(target, tree.Dereference) else None
