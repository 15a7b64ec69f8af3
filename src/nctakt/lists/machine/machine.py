# SPDX-License-Identifier: MIT
"""A machine folder -> ``Machine``.

In: a folder with a start-up list (or that list itself), ``None`` for the demo machine. Out: all
settings of its lists, immutable, and the mistakes in them. ``Failure`` is raised only if no machine
at all can result; everything else is mended and reported.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text, split_lines
from nctakt.files.access import FileAccess
from nctakt.lists.all_parameters import SCHEMA_BY_KIND
from nctakt.lists.declared.offsets import (
    ClampOffsets,
    ZeroOffsets,
    clamp_offsets_configuration,
    zero_offsets_configuration,
)
from nctakt.lists.declared.rtconf import RtconfConfiguration
from nctakt.lists.declared.schemas import (
    AXIS,
    CHANNEL,
    CLAMP_OFFSETS,
    RTCONF,
    STARTUP,
    TOOLS,
    VARIABLES,
    ZERO_OFFSETS,
)
from nctakt.lists.declared.startup import (
    ChannelStartup,
    StartupConfiguration,
    startup_configuration,
)
from nctakt.lists.declared.technology_functions import check_lead_times
from nctakt.lists.declared.tools import Tool, tools_configuration
from nctakt.lists.format import arguments
from nctakt.lists.format.times import Time
from nctakt.lists.format.values import Values
from nctakt.lists.format.without_effect import Detail
from nctakt.lists.machine.axis_configuration import AxisConfiguration, axis_configuration
from nctakt.lists.machine.channel_axes import (
    ChannelAxis,
    ChannelSpindle,
    c_axis_index,
    channel_axes,
    channel_spindles,
)
from nctakt.lists.machine.channel_configuration import ChannelParameters, channel_parameters
from nctakt.lists.machine.external.variables import (
    IgnoredVariable,
    Variable,
    VariablesConfiguration,
    VariableScope,
    channel_memory_bytes,
    variables_configuration,
)
from nctakt.lists.machine.external.variables_layout import check_memory, possible_variables
from nctakt.lists.machine.files import (
    BUILT_IN_MACHINES,
    DEMO_FOLDER,
    STARTUP_NAMES,
    ListSearch,
    machine_folder,
    read_file,
    startup_lists,
    startup_lists_below,
)
from nctakt.lists.machine.gantries import with_gantries
from nctakt.lists.machine.linked_lists import LinkedLists
from nctakt.lists.machine.schedules.scheduling import load_rtconf
from nctakt.lists.machine.schedules.scheduling_checks import check_contexts, check_time_limits
from nctakt.lists.machine.schedules.scheduling_profile import STANDARD_OPTIONS, RtconfOptions
from nctakt.messages import Collector
from nctakt.messages.machines.machine import (
    GLOBAL_VARIABLE_DECLARED_DIFFERENTLY,
    INVALID_LOGICAL_AXIS_NUMBER,
    LIST_FORMAT_NOT_SUPPORTED,
    MACHINE_FOLDER_MISSING,
    MACHINE_WITHOUT_CHANNELS,
    MANDATORY_PARAMETER_MISSING,
    RTCONF_MISSING,
    SEVERAL_STARTUP_LISTS,
    STARTUP_LIST_IN_FOLDER,
    STARTUP_LIST_MISSING,
)
from nctakt.messages.machines.variables import CHANNEL_VARIABLES_TOO_LARGE
from nctakt.messages.programs.user_errors import INVALID_USER_TEXT_LINE, USER_TEXTS_MISSING

#: NC cycle without rtconf.lis, in µs.
DEFAULT_CYCLE_TIME_US = 1000


HIGHEST_ID = 1000

_LINE = re.compile(r"\s*(\d{1,4})\s+(\S.*?)\s*$")


@dataclass(frozen=True, slots=True)
class ChannelConfiguration:
    """One channel; ``number`` counts from 1.

    ``external_variables`` holds the channel's own V.E variables and the GLOBAL ones that its list
    declares. ``tools``: all tools by number, valid or not. ``ignored_variables``: those of its list
    that have no possible type.
    """

    number: int
    startup: ChannelStartup
    parameters: ChannelParameters
    axes: tuple[ChannelAxis, ...]
    spindles: tuple[ChannelSpindle, ...]
    external_variables: tuple[Variable, ...]
    channel_variables: tuple[Variable, ...]
    tools: Mapping[int, Tool]
    zero_offsets: ZeroOffsets
    clamp_offsets: ClampOffsets
    ignored_variables: tuple[IgnoredVariable, ...] = ()

    @property
    def is_shifted(self) -> bool:
        """Whether offsets act when its first program starts."""
        zero, clamp = self.zero_offsets, self.clamp_offsets
        shifts = (
            *zero.groups.get(zero.default_group, {}).values(),
            *clamp.groups.get(0, {}).values(),
        )
        return any(shifts)

    @property
    def main_spindle(self) -> ChannelSpindle | None:
        """The spindle of the words S, M3, M4, M5 and M19."""
        return next((spindle for spindle in self.spindles if spindle.spindle.is_main), None)


@dataclass(frozen=True, slots=True, repr=False)
class Machine:
    """A machine as its lists describe it, immutable; ``load_machine`` reads it from a folder.

    ``folder`` is that of the start-up list. ``cycle_time_us``: the length of a tick. ``axes``: axes
    and spindles with a list, in the order of the start-up list. ``global_variables``: each GLOBAL
    V.E variable once, even if several lists declare it. ``user_texts``: the texts of the user's own
    errors by their ID. ``lists``: kind and file of each list, the start-up list first.

    >>> machine = load_machine()
    >>> machine.cycle_time_us, [axis.name for axis in machine.axes]
    (1000, ['X', 'Y', 'Z', 'A', 'S', 'S2'])
    >>> Controller(machine).read("V.RTA.ACS.ACT_POS.X")
    0.0
    """

    name: str
    folder: Path
    cycle_time_us: int
    startup: StartupConfiguration
    rtconf: RtconfConfiguration | None
    channels: tuple[ChannelConfiguration, ...]
    axes: tuple[AxisConfiguration, ...]
    global_variables: tuple[Variable, ...]
    user_texts: Mapping[int, str]
    lists: tuple[tuple[str, Path], ...]
    diagnostics: tuple[Diagnostic, ...]

    @property
    def is_demo(self) -> bool:
        """Whether this is the built-in demo machine."""
        return self.folder == DEMO_FOLDER

    def c_axis_of(self, channel: ChannelConfiguration) -> int:
        """Return the index in ``axes`` of the spindle that ``#CAX`` makes an axis; -1: none."""
        return c_axis_index(channel.main_spindle, self.axes)

    def __repr__(self) -> str:
        count = len(self.channels)
        channels = "1 channel" if count == 1 else f"{count} channels"
        axes = ", ".join(axis.name for axis in self.axes)
        return f"<Machine {self.name}: {channels}, axes {axes}, tick {Time(self.cycle_time_us)}>"


_BUILT_IN_FOLDERS = frozenset(DEMO_FOLDER.parent / name for name in BUILT_IN_MACHINES)


def load_machine(
    folder: str | Path | None = None,
    *,
    root: str | Path | None = None,
    detail: Detail = "summary",
    rtconf: RtconfOptions = STANDARD_OPTIONS,
    access: FileAccess | None = None,
) -> Machine:
    """Return the machine of ``folder``; without one, the built-in demo machine.

    ``folder`` may also be the start-up list itself, a folder with one somewhere in it, or the name
    of a built-in machine if there is no such folder. ``root``: the controller's root folder, in
    which the files that the lists name are searched. ``detail``: the extent of reports on entries
    without effect. ``rtconf``: the reading of its scheduling list. ``access`` limits the files that
    may be read; by default all. Raises ``Failure`` if the folder, the start-up list or every
    channel list is missing; other mistakes are in ``Machine.diagnostics``.

    >>> load_machine()
    <Machine demo: 1 channel, axes X, Y, Z, A, S, S2, tick 0.001 s>
    """
    root = None if root is None else arguments.path("root", root)
    access = access or FileAccess()
    folder = DEMO_FOLDER if folder is None else machine_folder(arguments.path("folder", folder))
    is_usual = root is None and detail == "summary" and rtconf == STANDARD_OPTIONS
    if is_usual and folder in _BUILT_IN_FOLDERS and not access.replaces_files:
        machine, read = _built_in(folder)
        access.note_all(read)
        return machine
    return _machine_of(folder, root, detail, rtconf, access)


@cache
def _built_in(folder: Path) -> tuple[Machine, FileAccess]:
    """Return a machine of the package, read once, and the access that has read its lists."""
    access = FileAccess()
    return _machine_of(folder, None, "summary", STANDARD_OPTIONS, access), access


def _machine_of(
    folder: Path, root: Path | None, detail: Detail, rtconf: RtconfOptions, access: FileAccess
) -> Machine:
    collector = Collector()
    startup_file = _startup_file(folder, collector)
    user_folder = folder if folder.is_dir() else None
    machine = load_startup(startup_file, user_folder, root, access, detail=detail, rtconf=rtconf)
    return replace(machine, diagnostics=(*collector.diagnostics, *machine.diagnostics))


def load_startup(
    startup_file: Path,
    user_folder: Path | None,
    root: Path | None,
    access: FileAccess,
    *,
    detail: Detail = "summary",
    rtconf: RtconfOptions = STANDARD_OPTIONS,
) -> Machine:
    """Return the machine of a start-up list; ``user_folder``: the folder that the user named.

    Otherwise as ``load_machine``.
    """
    search = ListSearch(startup_file, access, user_folder, root)
    return _Loader(startup_file, search, access, detail, rtconf).machine()


def _startup_file(folder: Path, collector: Collector) -> Path:
    """Return the start-up list of the user: the file, or the only one in the folder."""
    if folder.is_file():
        return folder
    if not folder.is_dir():
        names = ", ".join(BUILT_IN_MACHINES)
        collector.report(MACHINE_FOLDER_MISSING, None, path=folder.as_posix(), names=names)
        raise Failure(*collector.diagnostics)
    lists = startup_lists(folder)
    if lists and lists[0].name.casefold() in STARTUP_NAMES:
        return lists[0]
    lists = lists or startup_lists_below(folder)
    if len(lists) == 1:
        collector.report(STARTUP_LIST_IN_FOLDER, None, file=lists[0].as_posix())
        return lists[0]
    if lists:
        files = ", ".join(file.as_posix() for file in lists)
        collector.report(SEVERAL_STARTUP_LISTS, None, path=folder.as_posix(), files=files)
    else:
        names = ", ".join(STARTUP_NAMES)
        collector.report(STARTUP_LIST_MISSING, None, path=folder.as_posix(), names=names)
    raise Failure(*collector.diagnostics)


def _cycle_time_us(rtconf: RtconfConfiguration | None) -> int:
    """Return the length of a tick, which is the default without rtconf.lis."""
    return DEFAULT_CYCLE_TIME_US if rtconf is None else rtconf.cycle_time_us


class _Loader:
    """Loads the lists of one machine, which its start-up list names."""

    def __init__(
        self,
        startup_file: Path,
        search: ListSearch,
        access: FileAccess,
        detail: Detail,
        rtconf_options: RtconfOptions,
    ) -> None:
        self.rtconf_options = rtconf_options
        self.access = access
        self.startup_file = startup_file
        self.search = search
        self.folder = startup_file.parent
        self.collector = Collector()
        self.owners: dict[int, int] = {}
        self.startup_values = Values(STARTUP, startup_file.as_posix())
        self.axis_values: list[Values] = []
        self.channel_values: list[Values] = []
        self.variable_values: list[Values] = []
        self.lists = LinkedLists(startup_file, search, access, self.collector, detail=detail)

    def machine(self) -> Machine:
        startup = self._startup()
        rtconf = self._rtconf(startup)
        axes = self._axes(startup)
        parameters = self._channel_parameters(startup)
        for values in self.channel_values:
            check_lead_times(values, _cycle_time_us(rtconf), self.collector)
        if rtconf is not None:
            check_contexts(rtconf, parameters, self.collector)
            check_time_limits(rtconf, parameters, self.collector)
        for kind, reference in startup.others:
            self.lists.values(SCHEMA_BY_KIND[kind], reference)
        variables = tuple(self._variables(channel) for channel in startup.channels)
        variables = possible_variables(startup, variables, self.collector)
        shared, variables = self._share(variables)
        check_memory(startup, variables, self.startup_values, self.collector)
        channels = tuple(
            self._channel(startup, index, parameters[index], variables[index], axes)
            for index in range(len(startup.channels))
        )
        axes = with_gantries(axes, self.axis_values, self.owners, self.collector)
        texts = user_texts(startup.error_texts, self.search, self.access, self.collector)
        self.search.report_tolerance(self.collector)
        return Machine(
            self.folder.resolve().name,
            self.folder,
            _cycle_time_us(rtconf),
            startup,
            rtconf,
            channels,
            axes,
            shared,
            texts,
            (("startup", self.startup_file), *self.lists.files),
            tuple(self.collector.diagnostics),
        )

    def _startup(self) -> StartupConfiguration:
        values = self.lists.startup()
        if values is None:
            raise Failure(*self.collector.diagnostics)
        self.startup_values = values
        format_ = values.text("listen")
        if format_ not in {"ASCII", "XML"}:
            values.report(self.collector, LIST_FORMAT_NOT_SUPPORTED, ("listen",), format=format_)
            raise Failure(*self.collector.diagnostics)
        return startup_configuration(values, self.collector)

    def _rtconf(self, startup: StartupConfiguration) -> RtconfConfiguration | None:
        located = self.lists.data(RTCONF, startup.rtconf)
        if located is None:
            self.collector.report(RTCONF_MISSING, None, cycle=DEFAULT_CYCLE_TIME_US)
            return None
        path, data = located
        return load_rtconf(path.as_posix(), data, self.collector, self.rtconf_options)

    def _missing(self, key: str, count: str) -> None:
        """Report that ``key`` is missing, whose number is in the entry ``count``."""
        self.startup_values.report(self.collector, MANDATORY_PARAMETER_MISSING, (count,), key=key)

    def _axes(self, startup: StartupConfiguration) -> tuple[AxisConfiguration, ...]:
        base = self.lists.values(AXIS, startup.axis_defaults)
        axes: list[AxisConfiguration] = []
        for index, reference in enumerate(startup.axes):
            if reference is None:
                self._missing(f"achs_mds[{index}]", "zahl_mds")
            values = self.lists.values(AXIS, reference, base)
            if values is None:
                continue
            axis = axis_configuration(values, self.collector)
            number = axis.logical_number
            if number == 0 or any(other.logical_number == number for other in axes):
                values.report(
                    self.collector, INVALID_LOGICAL_AXIS_NUMBER, ("kopf.achs_nr",), logical=number
                )
                continue
            axes.append(axis)
            self.axis_values.append(values)
        return tuple(axes)

    def _channel_parameters(self, startup: StartupConfiguration) -> tuple[ChannelParameters, ...]:
        base = self.lists.values(CHANNEL, startup.channel_defaults)
        any_list = base is not None
        parameters: list[ChannelParameters] = []
        for channel in startup.channels:
            if channel.parameters is None and base is None:
                self._missing(f"sda_mds[{channel.index}]", "kanal_anzahl")
            values = self.lists.values(CHANNEL, channel.parameters, base)
            any_list = any_list or values is not None
            values = values or base or Values(CHANNEL, self.startup_file.as_posix())
            parameters.append(channel_parameters(values, self.collector))
            self.channel_values.append(values)
        if not any_list:
            self.collector.report(MACHINE_WITHOUT_CHANNELS, None)
            raise Failure(*self.collector.diagnostics)
        return tuple(parameters)

    def _variables(self, channel: ChannelStartup) -> VariablesConfiguration:
        values = self.lists.values(VARIABLES, channel.variables)
        self.variable_values.append(values or Values(VARIABLES, self.startup_file.as_posix()))
        if values is None:
            return VariablesConfiguration((), ())
        return variables_configuration(values, self.collector)

    def _share(
        self, lists: tuple[VariablesConfiguration, ...]
    ) -> tuple[tuple[Variable, ...], tuple[VariablesConfiguration, ...]]:
        """Return the GLOBAL variables of all channels; different ones become that of the first."""
        shared: dict[str, tuple[int, Variable]] = {}
        settled: list[VariablesConfiguration] = []
        for number, variables in enumerate(lists, start=1):
            external: list[Variable] = []
            for variable in variables.external:
                if variable.scope is not VariableScope.GLOBAL:
                    external.append(variable)
                    continue
                first, shared_variable = shared.setdefault(variable.name, (number, variable))
                if shared_variable != variable:
                    values = self.variable_values[number - 1]
                    span, line = values.where(("var[].name",), variable.name)
                    self.collector.report(
                        GLOBAL_VARIABLE_DECLARED_DIFFERENTLY,
                        span,
                        line,
                        name=variable.name,
                        channel=number,
                        first=first,
                    )
                external.append(shared_variable)
            settled.append(replace(variables, external=tuple(external)))
        return tuple(shared_variable for _, shared_variable in shared.values()), tuple(settled)

    def _channel(
        self,
        startup: StartupConfiguration,
        index: int,
        parameters: ChannelParameters,
        variables: VariablesConfiguration,
        axes: tuple[AxisConfiguration, ...],
    ) -> ChannelConfiguration:
        channel = startup.channels[index]
        values = self.channel_values[index]
        members = channel_axes(parameters, values, axes, index + 1, self.owners, self.collector)
        names = [member.name for member in members]
        own = tuple(axis for axis in parameters.axes if axis.name in names)
        parameters = replace(parameters, axes=own)
        linear = tuple(axes[member.index].is_linear for member in members)
        return ChannelConfiguration(
            index + 1,
            channel,
            parameters,
            members,
            channel_spindles(parameters, values, axes, self.collector),
            variables.external,
            self._channel_variables(parameters, values, variables),
            self._tools(channel, linear),
            self._zero_offsets(channel, len(linear)),
            self._clamp_offsets(channel, len(linear)),
            variables.ignored,
        )

    def _tools(self, channel: ChannelStartup, linear: tuple[bool, ...]) -> Mapping[int, Tool]:
        values = self.lists.values(TOOLS, channel.tools)
        return {} if values is None else tools_configuration(values, linear, self.collector)

    def _zero_offsets(self, channel: ChannelStartup, axis_count: int) -> ZeroOffsets:
        values = self.lists.values(ZERO_OFFSETS, channel.zero_offsets)
        if values is None:
            return ZeroOffsets()
        return zero_offsets_configuration(values, axis_count, self.collector)

    def _clamp_offsets(self, channel: ChannelStartup, axis_count: int) -> ClampOffsets:
        values = self.lists.values(CLAMP_OFFSETS, channel.clamp_offsets)
        if values is None:
            return ClampOffsets()
        return clamp_offsets_configuration(values, axis_count, self.collector)

    def _channel_variables(
        self, parameters: ChannelParameters, values: Values, variables: VariablesConfiguration
    ) -> tuple[Variable, ...]:
        needed = channel_memory_bytes(variables.channel)
        available = parameters.channel_variables_bytes
        if needed > available:
            key = "configuration.decoder.v_ch_memory"
            values.report(
                self.collector,
                CHANNEL_VARIABLES_TOO_LARGE,
                (key,),
                needed=needed,
                available=available,
            )
            return ()
        return variables.channel


def user_texts(
    path: str, search: ListSearch, access: FileAccess, collector: Collector
) -> dict[int, str]:
    """Return the texts of the file that the start-up list names, none without one."""
    if not path:
        return {}
    file = search.find(path)
    if file is None:
        collector.report(USER_TEXTS_MISSING, None, path=path)
        return {}
    data = read_file(file, access, collector)
    return {} if data is None else _texts(data, path, collector)


def _texts(data: bytes, name: str, collector: Collector) -> dict[int, str]:
    texts: dict[int, str] = {}
    for number, line in enumerate(split_lines(decode_text(data).text), 1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        match = _LINE.match(line)
        if match is None or not 1 <= int(match[1]) <= HIGHEST_ID:
            collector.report(INVALID_USER_TEXT_LINE, None, file=name, line=number)
            continue
        texts[int(match[1])] = match[2]
    return texts
