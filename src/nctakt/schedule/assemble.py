# SPDX-License-Identifier: MIT
"""Configuration + load -> model.

In: the effective rtconf.lis, the load, the choices of the rules. Out: ``Model``; a load that does
not fit the list, and processors that do not exist (P-RTCF-00015), go to the collector.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.declared.rtconf import (
    REALTIME_FUNCTION,
    InterruptSource,
    RtconfConfiguration,
    SchedulerThread,
    ThreadFunction,
)
from nctakt.lists.machine.schedules.scheduling_checks import is_realtime
from nctakt.lists.machine.schedules.scheduling_profile import Profile
from nctakt.messages import Collector
from nctakt.messages.scheduling.load import (
    CALL_COUNT_NOT_SIMULATED,
    EXECUTION_TIME_MISSING,
    INVALID_LOAD_VALUE,
    LOAD_ASSUMED,
    LOAD_INTERRUPT_WITHOUT_EFFECT,
    LOAD_OF_UNUSED_FUNCTION,
)
from nctakt.messages.scheduling.schedule_results import CPU_MISSING, CPU_NOT_ASSIGNABLE
from nctakt.schedule.load import ASSUMED, ASSUMED_EXTERNAL, ASSUMED_FUNCTION, Load
from nctakt.schedule.model import (
    ANY_CPU,
    NS_PER_US,
    STANDARD_RULES,
    Call,
    Execution,
    Model,
    Rules,
    Task,
    TaskClass,
    Train,
)

#: No more calls than this in one activation are simulated.
MAX_CALLS = 10_000

_OFFLINE = Text("it is offline or not available", "sie ist abgeschaltet oder nicht verfügbar")


def assemble(
    configuration: RtconfConfiguration,
    load: Load,
    profile: Profile,
    collector: Collector,
    *,
    rules: Rules = STANDARD_RULES,
    cpu_base: int = 1,
) -> Model:
    """Return the model; complete only if the collector has no errors but 1000180 and 1000181.

    ``cpu_base``: the number of the first processor in ``thread[i].cpu``.
    """
    return _Assembly(configuration, load, profile, collector, rules, cpu_base).model()


class _Assembly:
    def __init__(
        self,
        configuration: RtconfConfiguration,
        load: Load,
        profile: Profile,
        collector: Collector,
        rules: Rules,
        cpu_base: int,
    ) -> None:
        self._configuration = configuration
        self._load = load
        self._profile = profile
        self._collector = collector
        self._rules = rules
        self._cpu_base = cpu_base
        self._missing: list[str] = []
        self._cpus = self._find_cpus()

    def model(self) -> Model:
        configuration, load = self._configuration, self._load
        if load.is_assumed:
            self._collector.report(LOAD_ASSUMED, None)
        threads = self._threads()
        tasks = (*threads, *self._external_threads(threads))
        self._check_load()
        used = tuple(sorted({task.cpu for task in tasks}))
        windows_cpus = self._cpus if ANY_CPU in used or not used else used
        if load.windows_cpus is not None:
            windows_cpus = tuple(cpu for cpu in load.windows_cpus if cpu in self._cpus)
        cycle = configuration.cycle_time_us * NS_PER_US
        return Model(
            configuration.interrupt_source,
            cycle,
            configuration.time_slice_us * NS_PER_US,
            configuration.windows_time_us * NS_PER_US,
            self._train(cycle),
            tasks,
            self._cpus,
            windows_cpus,
            load.overheads,
            self._rules,
            load.seed,
            configuration.schedule,
        )

    def _find_cpus(self) -> tuple[int, ...]:
        """The processors that can be used; without a number those that the list names."""
        numbers = [thread.cpu - self._cpu_base + 1 for thread in self._configuration.threads]
        numbers += [
            self._load.external[one.semaphore_name].cpu
            for one in self._configuration.external_threads
            if one.semaphore_name in self._load.external
        ]
        count = max((1, *numbers)) if self._load.cpus is None else self._load.cpus
        usable = tuple(cpu for cpu in range(1, count + 1) if cpu not in self._load.offline)
        if usable:
            return usable
        expected = Text(
            "a list that leaves at least one CPU", "eine Liste, die eine CPU übrig lässt"
        )
        self._collector.report(
            INVALID_LOAD_VALUE,
            None,
            key="machine.offline",
            value=list(self._load.offline),
            expected=expected,
        )
        return (1,)

    def _cpu(self, cpu: int, name: str) -> int:
        """The processor of a thread, or ``ANY_CPU``."""
        if cpu in self._cpus:
            return cpu
        count = max((*self._cpus, *self._load.offline))
        if cpu in self._load.offline:
            self._collector.report(CPU_NOT_ASSIGNABLE, None, thread=name, cpu=cpu, reason=_OFFLINE)
        else:
            self._collector.report(CPU_MISSING, None, thread=name, cpu=cpu, cpus=count)
        return ANY_CPU

    def _train(self, cycle: int) -> Train:
        entries = self._load.interrupt
        phase = entries.get("phase", 0)
        if self._configuration.interrupt_source is InterruptSource.TIMER:
            for key in ("period", "drift", "jitter"):
                if key in entries:
                    self._collector.report(LOAD_INTERRUPT_WITHOUT_EFFECT, None, key=key)
            return Train(cycle, phase)
        period = entries.get("period", cycle)
        drift = entries.get("drift", 0)
        if period + drift <= 0:
            expected = Text("more than minus the period", "mehr als minus die Periode")
            self._collector.report(
                INVALID_LOAD_VALUE,
                None,
                key="interrupt.drift",
                value=drift / NS_PER_US,
                expected=expected,
            )
            drift = 0
        # Two interrupts never change places.
        jitter = min(entries.get("jitter", 0), (period + drift - 1) // 2)
        return Train(period, phase, drift, jitter, is_phase_known="phase" in entries)

    def _threads(self) -> list[Task]:
        threads = self._configuration.threads
        cycle = self._configuration.cycle_time_us
        highest = max(
            threads, key=lambda candidate: self._urgency(candidate.priority), default=None
        )
        has_realtime = any(is_realtime(thread) for thread in threads)
        return [
            Task(
                f"thread[{thread.index}]",
                thread.name or f"thread[{thread.index}]",
                TaskClass.REALTIME
                if (is_realtime(thread) if has_realtime else thread is highest)
                else TaskClass.ASYNCHRONOUS,
                thread.cycle_us // cycle,
                self._urgency(thread.priority),
                self._cpu(thread.cpu - self._cpu_base + 1, thread.name),
                self._calls(thread),
                thread.error_on_overflow,
            )
            for thread in threads
        ]

    def _urgency(self, priority: int) -> int:
        # Even numbers: one between two priorities is free for "right after".
        return 2 * self._profile.urgency(priority)

    def _calls(self, thread: SchedulerThread) -> tuple[Call, ...]:
        count = sum(function.calls_per_cycle for function in thread.functions)
        if count > MAX_CALLS:
            self._collector.report(
                CALL_COUNT_NOT_SIMULATED, None, thread=thread.name, count=count, limit=MAX_CALLS
            )
            return ()
        rounds = max((function.calls_per_cycle for function in thread.functions), default=0)
        if self._rules.calls == "block":
            order = [
                (number, function)
                for function in thread.functions
                for number in range(function.calls_per_cycle)
            ]
        else:
            order = [
                (number, function)
                for number in range(rounds)
                for function in thread.functions
                if number < function.calls_per_cycle
            ]
        times = {called.index: self._execution(thread, called) for called in thread.functions}
        return tuple(
            Call(
                function.name,
                number,
                times[function.index],
                function.trace_bit,
                function.index,
            )
            for number, function in order
        )

    def _execution(self, thread: SchedulerThread, function: ThreadFunction) -> Execution:
        path = f"thread[{thread.index}].function[{function.index}]"
        for key in (path, function.name):
            if key in self._load.functions:
                execution = self._load.functions[key]
                if execution.parts and function.name != REALTIME_FUNCTION:
                    self._refuse_parts(key, execution.parts)
                return execution
        assumed = ASSUMED.functions.get(function.name, ASSUMED_FUNCTION)
        if not self._load.is_assumed and function.name not in self._missing:
            self._missing.append(function.name)
            self._report_assumed(function.name, f'functions."{function.name}"', assumed)
        return assumed

    def _report_assumed(self, name: str, entry: str, execution: Execution) -> None:
        """Report a time that the load does not have."""
        time = execution.longest // NS_PER_US
        self._collector.report(EXECUTION_TIME_MISSING, None, name=name, time=time, entry=entry)

    def _refuse_parts(self, key: str, parts: tuple[int, ...]) -> None:
        """Report parts of a function other than the interpolation."""
        expected = Text(
            f"a time: only {REALTIME_FUNCTION} has parts",
            f"eine Zeit: nur {REALTIME_FUNCTION} hat Teile",
        )
        self._collector.report(
            INVALID_LOAD_VALUE,
            None,
            key=f"functions.{key}",
            value=[part / NS_PER_US for part in parts],
            expected=expected,
        )

    def _external_threads(self, threads: list[Task]) -> list[Task]:
        tasks: list[Task] = []
        realtime = [task.urgency for task in threads if task.kind is TaskClass.REALTIME]
        for thread in self._configuration.external_threads:
            name = thread.semaphore_name
            load = self._load.external.get(name)
            execution = None if load is None else load.execution
            if execution is None:
                execution = ASSUMED_EXTERNAL
                if not self._load.is_assumed:
                    self._report_assumed(name, f'external."{name}".time', execution)
            urgency = min(realtime, default=0) - 1
            if load is not None and load.priority is not None:
                urgency = self._urgency(load.priority)
            tasks.append(
                Task(
                    f"external_thread[{thread.index}]",
                    name,
                    TaskClass.EXTERNAL,
                    thread.cycle_us // self._configuration.cycle_time_us,
                    urgency,
                    self._cpu(1 if load is None else load.cpu, name),
                    (Call(name, 0, execution),),
                )
            )
        return tasks

    def _check_load(self) -> None:
        """Report names of the load that the list does not have."""
        if self._load.is_assumed:
            return
        threads = self._configuration.threads
        functions = [item.name for thread in threads for item in thread.functions]
        paths = [
            f"thread[{thread.index}].function[{item.index}]"
            for thread in threads
            for item in thread.functions
        ]
        external = [item.semaphore_name for item in self._configuration.external_threads]
        for entries, names in ((self._load.functions, functions), (self._load.external, external)):
            shown = ", ".join(dict.fromkeys(names))
            for name in entries:
                if name not in names and name not in paths:
                    self._collector.report(
                        LOAD_OF_UNUSED_FUNCTION, None, name=name, names=shown or "–"
                    )
