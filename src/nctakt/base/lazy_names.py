# SPDX-License-Identifier: MIT
"""Names of a package that are imported when they are first used (PEP 562)."""

TYPE_CHECKING = False  # type checkers know better, and importing typing takes longer than this
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping


def import_when_used(
    namespace: "dict[str, object]", modules: "Mapping[str, str]"
) -> "Callable[[str], object]":
    """Return the ``__getattr__`` of the package with this ``namespace`` (its ``globals()``).

    ``modules``: the module of each name.
    """

    def find(name: str) -> object:
        if name not in modules:
            raise AttributeError(f"module {namespace['__name__']!r} has no attribute {name!r}")
        from importlib import import_module  # noqa: PLC0415 - nothing before it is needed

        value: object = getattr(import_module(modules[name]), name)
        namespace[name] = value
        return value

    return find
