# SPDX-License-Identifier: MIT
"""The compiled modules: found by their types, translated by Cython, built by a C compiler.

Each ``module.py`` with a ``module.pxd`` beside it is compiled. What Cython needs in all of them is
built once, as ``nctakt._cython``. Without a C compiler the package is installed as plain Python:
all modules are compiled or none is, since a compiled class derives from no other kind.

With ``NCTAKT_ABI3=1`` the modules keep to Python's limited API: one wheel serves all versions from
the oldest on. Otherwise they are for the Python that builds them, and decode some per cent faster.

``build_ext --checked`` builds modules that find faults instead of being fast: with bounds checks,
and under Linux with the sanitizers of addresses and of undefined behaviour.
"""

import gc
import os
import re
import runpy
import sys
import sysconfig
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext, get_abi3_suffix
from setuptools.command.build_py import build_py
from setuptools.dist import Distribution
from setuptools.errors import BaseError, CCompilerError
from setuptools.modified import newer

SOURCES = Path("src")
SHARED = "nctakt._cython"
SHARED_SOURCE = "src/nctakt/_cython.c"
#: The oldest Python of a wheel for many; nothing where the modules are for this Python alone.
OLDEST = (3, 11) if os.environ.get("NCTAKT_ABI3") == "1" else ()
#: How the file of a module ends.
ENDING = get_abi3_suffix() if OLDEST else sysconfig.get_config_var("EXT_SUFFIX")
#: What copies the state of the realtime part: written by each build from the C types.
STATE = "nctakt.kernel._state"
STATE_SOURCE = Path("src/nctakt/kernel/_state.pyx")
#: How C types and constants are taken from other modules.
CIMPORT = re.compile(r"^from (nctakt[\w.]*) cimport (.+)$", re.MULTILINE)
#: What holds in each compiled module whose first lines say nothing else.
DIRECTIVES = {
    "language_level": 3,
    "annotation_typing": False,
    "auto_pickle": False,
    "boundscheck": False,
    "cdivision": True,
    "emit_code_comments": False,
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
#: gcc follows a pointer that is null into a branch that tests for null, and warns of what is there.
QUIET = ["-Wno-stringop-overflow"]
#: What of a module runs once, when it is imported, is not worth the time of an optimization.
if sys.platform == "linux":
    FAST.append('-DCYTHON_SMALL_CODE=__attribute__((cold, optimize("O0")))')
#: The versions of Cython that translate a module with C types read before as they do without.
SHARES_TYPES = ("3.2.", "3.3.")
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
    found.append(Extension(STATE, [STATE_SOURCE.as_posix()]))
    if sys.platform == "linux":
        folder = SOURCES / "nctakt" / "schedule" / "real"
        sources = sorted(path.as_posix() for path in folder.glob("*.c"))
        headers = sorted(path.as_posix() for path in folder.glob("*.h"))
        found.append(Extension("nctakt.schedule.real.processes", sources, depends=headers))
    for one in found if OLDEST else ():
        one.py_limited_api = True
        one.define_macros = [("Py_LIMITED_API", "0x{:02x}{:02x}0000".format(*OLDEST))]
    return found


def cimports() -> dict[Path, set[Path]]:
    """Return the ``.pxd`` files whose types or constants each file of the sources takes."""
    found: dict[Path, set[Path]] = {}
    for path in [*SOURCES.rglob("*.pxd"), STATE_SOURCE]:
        taken = found.setdefault(path, set())
        for module, names in CIMPORT.findall(path.read_text("utf-8")):
            folder = SOURCES.joinpath(*module.split("."))
            files = [folder, *(folder / name for name in names.replace(",", " ").split())]
            taken.update(file for one in files if (file := one.with_suffix(".pxd")).exists())
    return found


def files_of(source: Path, needed: dict[Path, set[Path]]) -> set[Path]:
    """Return the files that the C file of a module depends on, with all that these take."""
    found = {Path("setup.py")}
    waiting = [path for path in (source, source.with_suffix(".pxd")) if path.exists()]
    while waiting:
        path = waiting.pop()
        if path not in found:
            found.add(path)
            waiting += needed.get(path, ())
    return found


def module_name(path: Path) -> str:
    """Return the name of the module whose source or C types are in a file."""
    return ".".join(path.relative_to(SOURCES).with_suffix("").parts)


def run_in_forks(jobs: dict[str, Callable[[], bool]], processes: int) -> None:
    """Do each job in a fork of this process.

    Raise ``BaseError`` where one does not return true, and name all of these.
    """
    sys.stdout.flush()
    sys.stderr.flush()
    # What is there now lives on: no fork has to look through it for what it could free.
    gc.freeze()
    running: dict[int, str] = {}
    failed = []
    waiting = list(jobs)
    while waiting or running:
        if not waiting or len(running) == processes:
            process, status = os.wait()
            name = running.pop(process)
            if status:
                failed.append(name)
            continue
        name = waiting.pop(0)
        process = os.fork()
        if process:
            running[process] = name
            continue
        is_done = False
        try:
            is_done = jobs[name]()
        except BaseException:  # noqa: BLE001, the process ends here
            traceback.print_exc()
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(not is_done)
    gc.unfreeze()
    if failed:
        raise BaseError(f"not translated: {', '.join(sorted(failed))}")


def translations(
    modules: list[Extension], folder: Path, directives: dict[str, Any]
) -> dict[str, Callable[[], bool]]:
    """Return what translates each of the modules in a fork of this process.

    All C types are read here. ``cythonize`` reads for each module anew those that it needs, which
    takes most of its time. The C files are the same but for the order of declarations. A module
    that has to do with no array reads its types itself: it would get Cython's code for arrays, and
    not the type which that needs, because other modules have declared some.
    """
    from Cython.Compiler import Main  # noqa: PLC0415
    from Cython.Compiler.Options import CompilationOptions  # noqa: PLC0415

    settings: dict[str, Any] = {
        "compiler_directives": directives,
        "include_path": [str(SOURCES)],
        "shared_utility_qualified_name": SHARED,
    }
    options = CompilationOptions(**settings)
    options.configure_language_defaults("py")
    context = Main.Context.from_options(options)
    needed = cimports()
    for path in sorted(needed):
        if path.suffix == ".pxd":
            context.find_module(module_name(path))

    def translate(one: Extension) -> bool:
        source = Path(one.sources[0])
        files = files_of(source, needed) - {Path("setup.py")}
        own = {module_name(path) for path in files if path.suffix == ".pxd"}
        has_arrays = any("::1]" in path.read_text("utf-8") for path in files)
        context.pxds = {
            name: types
            for name, types in context.pxds.items()
            if str(types[1].qualified_name) in own
        }
        target = folder / source.with_suffix(".c")
        target.parent.mkdir(parents=True, exist_ok=True)
        found = Main.compile_single(
            str(source),
            CompilationOptions(**settings, output_file=str(target)),
            one.name,
            context=context if has_arrays else None,
        )
        return found.num_errors == 0

    return {one.name: lambda one=one: translate(one) for one in modules}


def write_state_source() -> None:
    """Write the module that copies the realtime part's state, if the C types have changed."""
    kernel = STATE_SOURCE.parent
    text = runpy.run_path(str(kernel / "state_fields.py"))["compiled_source"](kernel)
    if not STATE_SOURCE.exists() or STATE_SOURCE.read_text("utf-8") != text:
        STATE_SOURCE.write_text(text, "utf-8")


def remove_strangers(folder: Path) -> None:
    """Remove from a folder what earlier builds have left and the sources no longer have."""
    compiled = {one.name.replace(".", "/") + ENDING for one in extensions()}
    for path in [path for path in folder.rglob("*") if path.is_file()]:
        place = path.relative_to(folder)
        if path.suffix in (".so", ".pyd"):
            belongs = place.as_posix() in compiled
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
        if OLDEST:
            self.build_temp += "-abi3"

    def build_extensions(self) -> None:
        """Build all modules, or none where C cannot be compiled."""
        self.translate()
        for one in self.extensions:
            one.depends = [*one.depends, "setup.py"]
            if self.compiler.compiler_type != "msvc":
                one.extra_compile_args = [*QUIET, *(CHECKED if self.checked else FAST)]
            if self.checked and sys.platform == "linux":
                one.extra_compile_args = [*QUIET, *CHECKED, *SANITIZERS]
                one.extra_link_args = SANITIZERS
        # The largest first: at the end, one alone would keep all other processors waiting.
        self.extensions.sort(key=lambda one: -Path(one.sources[0]).stat().st_size)
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
        from Cython.Compiler import Options  # noqa: PLC0415

        # All arrays have one dimension, which is the most of them less one. Left at 8, each array
        # in an object or a call has 208 bytes instead of 64. Set before what reads it is imported.
        Options.buffer_max_dims = 2
        from Cython.Build import cythonize  # noqa: PLC0415

        write_state_source()
        folder = Path(f"build/cython-{version}{'-checked' if self.checked else ''}")
        needed = cimports()
        stale = []
        for one in self.extensions:
            source = Path(one.sources[0])
            if source.suffix != ".c" or one.name == SHARED:
                translated = folder / source.with_suffix(".c")
                if any(newer(str(file), str(translated)) for file in files_of(source, needed)):
                    stale.append(one)
        # What is up to date is not shown to Cython: it would look at its own files, too, which are
        # new in each environment that pip builds in.
        directives = DIRECTIVES | {"boundscheck": self.checked}

        def translate_alone(modules: list[Extension], processes: int) -> bool:
            cythonize(
                modules,
                build_dir=str(folder),
                compiler_directives=directives,
                force=True,
                nthreads=processes,
                quiet=True,
                shared_utility_qualified_name=SHARED,
            )
            return True

        if sys.platform != "linux" or not version.startswith(SHARES_TYPES):
            translate_alone(stale, self.parallel)
        elif stale:
            jobs = translations([one for one in stale if one.name != SHARED], folder, directives)
            for one in stale:
                if one.name == SHARED:
                    jobs[SHARED] = lambda one=one: translate_alone([one], 0)
            run_in_forks(jobs, self.parallel)
        for one in self.extensions:
            source = Path(one.sources[0])
            if source.suffix != ".c" or one.name == SHARED:
                one.sources = [str(folder / source.with_suffix(".c"))]

    def copy_extensions_to_source(self) -> None:
        """Copy the modules beside their sources, and remove those of modules that have moved."""
        remove_strangers(SOURCES)
        super().copy_extensions_to_source()


if __name__ == "__main__":
    setup(
        ext_modules=extensions(),
        cmdclass={"build_py": BuildModules, "build_ext": BuildExtensions},
        options={"bdist_wheel": {"py_limited_api": OLDEST and "cp{}{}".format(*OLDEST)}},
    )
