# SPDX-License-Identifier: MIT
"""The compiled modules: found by their types, translated by Cython, built by a C compiler.

Each ``module.py`` with a ``module.pxd`` beside it is compiled. What Cython needs in all of them is
built once, as ``nctakt._cython``. Without a C compiler the package is installed as plain Python:
all modules are compiled or none is, since a compiled class derives from no other kind.

``build_ext --checked`` builds modules that find faults instead of being fast: with bounds checks,
and under Linux with the sanitizers of addresses and of undefined behaviour.
"""

import os
import sys
from pathlib import Path
from typing import ClassVar

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py
from setuptools.dist import Distribution
from setuptools.errors import BaseError, CCompilerError
from setuptools.modified import newer

SOURCES = Path("src")
SHARED = "nctakt._cython"
SHARED_SOURCE = "src/nctakt/_cython.c"
#: What holds in each compiled module whose first lines say nothing else.
DIRECTIVES = {
    "language_level": 3,
    "annotation_typing": False,
    "auto_pickle": False,
    "boundscheck": False,
    "cdivision": True,
    "initializedcheck": False,
    "nonecheck": False,
    "show_performance_hints": False,
    "wraparound": False,
}
#: The same bits on every machine: no multiplication is contracted with an addition. Each module
#: runs in the tick, decodes programs or simulates schedules, and has its row in ``benchmarks/``, so
#: none is built with ``-O1``; for ``schedule/`` alone that would save two seconds.
FAST = ["-O2", "-g0", "-ffp-contract=off"]
CHECKED = ["-O1", "-g0", "-ffp-contract=off"]
#: Not twice what the sanitizer of addresses finds: these four take as long to compile as the rest.
SANITIZERS = [
    "-fsanitize=address,undefined",
    "-fno-sanitize=null,alignment,object-size,pointer-overflow",
    "-fno-sanitize-recover=undefined",
]


def typed_modules() -> list[Path]:
    """Return the modules that are compiled, sorted.

    A .pxd of C functions or of numbers alone is no module: it stands in for one wherever it is
    cimported.
    """
    found = []
    for path in SOURCES.rglob("*.pxd"):
        text = path.read_text("utf-8")
        if "cdef extern" not in text and "cdef enum" not in text:
            found.append(path.with_suffix(".py"))
    return sorted(found)


def extensions() -> list[Extension]:
    """Return the compiled modules of this platform as extensions."""
    found = [
        Extension(".".join(path.relative_to(SOURCES).with_suffix("").parts), [path.as_posix()])
        for path in typed_modules()
    ]
    found.append(Extension(SHARED, [SHARED_SOURCE]))
    if sys.platform == "linux":
        folder = SOURCES / "nctakt" / "linux"
        sources = sorted(path.as_posix() for path in folder.glob("*.c"))
        headers = sorted(path.as_posix() for path in folder.glob("*.h"))
        found.append(Extension("nctakt.linux.processes", sources, depends=headers))
    return found


def remove_strangers(folder: Path) -> None:
    """Remove from a folder what earlier builds have left and the sources no longer have."""
    compiled = {one.name.replace(".", "/") for one in extensions()}
    for path in [path for path in folder.rglob("*") if path.is_file()]:
        place = path.relative_to(folder)
        if path.suffix in (".so", ".pyd"):
            belongs = place.with_name(place.name.split(".")[0]).as_posix() in compiled
        else:
            belongs = (SOURCES / place).exists()
        if not belongs:
            path.unlink()


class BuildModules(build_py):
    """Copies the modules that there are into a folder that may hold those of an earlier build."""

    def run(self) -> None:
        """Copy the modules."""
        if not self.editable_mode:
            remove_strangers(Path(self.build_lib))
        super().run()


class BuildExtensions(build_ext):
    """Translates and compiles in as many processes as there are processors."""

    user_options: ClassVar = [
        *build_ext.user_options,
        ("checked", None, "build with bounds checks and sanitizers"),
    ]
    boolean_options: ClassVar = [*build_ext.boolean_options, "checked"]

    def initialize_options(self) -> None:
        """Set what no option says."""
        super().initialize_options()
        self.checked = False
        self.parallel = os.cpu_count() or 1

    def finalize_options(self) -> None:
        """Build for an editable installation where any other build finds the modules again."""
        super().finalize_options()
        if self.editable_mode:
            build = Distribution().get_command_obj("build")
            build.ensure_finalized()
            self.build_lib, self.build_temp = build.build_platlib, build.build_temp

    def build_extensions(self) -> None:
        """Build all modules, or none where C cannot be compiled."""
        self.translate()
        for one in self.extensions:
            one.depends = [*one.depends, "setup.py"]
            if self.compiler.compiler_type != "msvc":
                one.extra_compile_args = CHECKED if self.checked else FAST
            if self.checked and sys.platform == "linux":
                one.extra_compile_args = [*CHECKED, *SANITIZERS]
                one.extra_link_args = SANITIZERS
        try:
            super().build_extensions()
        except (CCompilerError, BaseError) as error:
            self.warn(f"C cannot be compiled, so plain Python is installed: {error}")
            for one in self.extensions:
                Path(self.get_ext_fullpath(one.name)).unlink(missing_ok=True)
            self.extensions = []

    def translate(self) -> None:
        """Replace the sources of the extensions with their C files, and make those that are old."""
        # A build needs Cython; a look at the version does not.
        from Cython import __version__ as version  # noqa: PLC0415
        from Cython.Build import cythonize  # noqa: PLC0415

        folder = f"build/cython-{version}{'-checked' if self.checked else ''}"
        translated = cythonize(
            self.extensions,
            build_dir=folder,
            compiler_directives=DIRECTIVES | {"boundscheck": self.checked},
            # Cython does not see that a module depends on ``cimport``-ed modules of constants.
            force=any(
                newer(str(file), f"{folder}/{SHARED_SOURCE}")
                for file in (Path("setup.py"), *SOURCES.rglob("*.pxd"))
            ),
            nthreads=self.parallel,
            quiet=True,
            shared_utility_qualified_name=SHARED,
        )
        sources = {one.name: one.sources for one in translated}
        for one in self.extensions:
            one.sources = sources[one.name]

    def copy_extensions_to_source(self) -> None:
        """Copy the modules beside their sources, and remove those of modules that have moved."""
        remove_strangers(SOURCES)
        super().copy_extensions_to_source()


if __name__ == "__main__":
    setup(
        ext_modules=extensions(),
        cmdclass={"build_py": BuildModules, "build_ext": BuildExtensions},
    )
