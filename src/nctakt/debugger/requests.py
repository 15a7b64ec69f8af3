# SPDX-License-Identifier: MIT
"""Requests about a program under the debugger: breakpoints, steps, stacks, values.

In: the arguments of a request. Out: the body of its answer, and the actions after that has been
sent. Raises ``Failure`` for impossible requests.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nctakt.base.failure import Failure
from nctakt.debugger.arguments import Arguments
from nctakt.debugger.breakpoints import Breakpoint, data_id, shown
from nctakt.debugger.debuggee import Debuggee
from nctakt.debugger.exceptions import fault_info, info
from nctakt.debugger.values import shown_value
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import (
    NO_LINE_TO_STOP_AT,
    NOT_IN_THE_RUN,
    UNKNOWN_REFERENCE,
    UNKNOWN_REQUEST,
)
from nctakt.plc.stepping.shown import PlcValue
from nctakt.session.stops import Kind, StopAt, read_stop

Body = dict[str, Any]

#: Frames that are shown at most, where a client asks for all.
MAX_FRAMES = 1000


class Requests:
    """The requests of a client about a program."""

    def __init__(self, debuggee: Debuggee) -> None:
        self._debuggee = debuggee
        self._then: Callable[[], None] | None = None
        self._handlers: dict[str, Callable[[Arguments], Body]] = {
            "setBreakpoints": self._set_breakpoints,
            "setFunctionBreakpoints": self._set_function_breakpoints,
            "setDataBreakpoints": self._set_data_breakpoints,
            "setExceptionBreakpoints": self._set_exception_breakpoints,
            "dataBreakpointInfo": self._data_breakpoint_info,
            "breakpointLocations": self._breakpoint_locations,
            "exceptionInfo": self._exception_info,
            "continue": self._continue,
            "pause": self._pause,
            "next": lambda arguments: self._step("next", arguments, up=0),
            "stepIn": lambda arguments: self._step("stepIn", arguments, up=None),
            "stepOut": lambda arguments: self._step("stepOut", arguments, up=1),
            "stepBack": self._step_back,
            "reverseContinue": self._reverse_continue,
            "restartFrame": self._restart_frame,
            "disassemble": debuggee.disassembly.answer,
            "threads": self._threads,
            "stackTrace": self._stack_trace,
            "scopes": self._scopes,
            "variables": self._variables,
            "setVariable": self._set_variable,
            "setExpression": self._set_expression,
            "evaluate": self._evaluate,
            "completions": self._completions,
            "loadedSources": self._loaded_sources,
            "source": self._source,
        }

    def answer(self, command: str, arguments: Arguments) -> Body:
        """Return the body of the answer to a request; raises ``Failure``."""
        handler = self._handlers.get(command)
        if handler is None:
            raise Failure(diagnostic(UNKNOWN_REQUEST, command=command))
        return handler(arguments)

    def follow(self) -> None:
        """Run the actions after the answer to the last request."""
        then, self._then = self._then, None
        if then is not None:
            then()

    # --- breakpoints ----------------------------------------------------------------------------

    def _set_breakpoints(self, arguments: Arguments) -> Body:
        asked = arguments.part("source")
        file = self._debuggee.sources.name_of(asked)
        entries = arguments.parts("breakpoints")
        if not entries:
            entries = [Arguments({"line": line}) for line in arguments.items("lines")]
        shown_name = asked.text("path", "") or asked.text("name", "")
        new = [self._at_line(one, asked) for one in entries]
        self._debuggee.report_changed_files()
        return self._put(f"source {file or shown_name}", new)

    def _at_line(self, arguments: Arguments, source: Arguments) -> Breakpoint:
        """Return the breakpoint at a line, or at the next one where the run can stop."""
        new = self._placed(arguments, source)
        new.source = source
        return new

    def _placed(self, arguments: Arguments, source: Arguments) -> Breakpoint:
        debuggee = self._debuggee
        file = debuggee.sources.name_of(source)
        shown_name = source.text("path", "") or source.text("name", "")
        line = arguments.number("line")
        if file is None:
            new = debuggee.breakpoints.make("source", arguments, line=line)
            new.mistake = Failure(diagnostic(NOT_IN_THE_RUN, file=shown_name))
            return new
        location = debuggee.places(file).at_or_after(line)
        if location is None:
            new = debuggee.breakpoints.make("source", arguments, file=file, line=line)
            new.mistake = Failure(diagnostic(NO_LINE_TO_STOP_AT, line=line))
            return new
        return debuggee.breakpoints.at_place(arguments, file, location)

    def _set_function_breakpoints(self, arguments: Arguments) -> Body:
        make = self._debuggee.breakpoints.of_function
        return self._put("functions", [make(one) for one in arguments.parts("breakpoints")])

    def _set_data_breakpoints(self, arguments: Arguments) -> Body:
        make = self._debuggee.breakpoints.of_data
        return self._put("data", [make(one) for one in arguments.parts("breakpoints")])

    def _put(self, group: str, new: list[Breakpoint]) -> Body:
        """Set breakpoints; return them as the client is shown them."""
        debuggee = self._debuggee
        debuggee.breakpoints.verify(new, debuggee.check_stops)
        debuggee.breakpoints.set(group, new)
        debuggee.breakpoints.bound()
        debuggee.watch()
        return {"breakpoints": [self._shown(one) for one in new]}

    def _shown(self, breakpoint_: Breakpoint) -> Body:
        file = breakpoint_.file
        source = self._debuggee.sources.source(file) if file else None
        return shown(breakpoint_, source, self._debuggee.language)

    def verify_all(self) -> list[Body]:
        """Find all breakpoints again in a program that is restarted; return them as shown."""
        debuggee = self._debuggee
        debuggee.breakpoints.renew(self._again)
        debuggee.breakpoints.verify(debuggee.breakpoints.all, debuggee.check_stops)
        debuggee.breakpoints.bound()
        debuggee.watch()
        return [self._shown(one) for one in debuggee.breakpoints.all]

    def _again(self, breakpoint_: Breakpoint) -> Breakpoint:
        """Return a breakpoint as in this program."""
        make = self._debuggee.breakpoints
        if breakpoint_.source is not None:
            return self._at_line(breakpoint_.asked, breakpoint_.source)
        if breakpoint_.kind == "function":
            return make.of_function(breakpoint_.asked)
        return make.of_data(breakpoint_.asked)

    def _set_exception_breakpoints(self, arguments: Arguments) -> Body:
        self._debuggee.exceptions.set(arguments)
        self._debuggee.watch()
        return {}

    def _data_breakpoint_info(self, arguments: Arguments) -> Body:
        """Return whether a variable or an expression can be watched."""
        debuggee = self._debuggee
        name, channel = arguments.text("name"), 1
        if arguments.has("variablesReference"):
            name, channel = debuggee.scopes.full_name(arguments.number("variablesReference"), name)
        elif arguments.has("frameId"):
            channel = debuggee.scopes.channel_of_frame(arguments.number("frameId"))
        mode: Kind = "written" if arguments.text("mode", "") == "written" else "changes"
        try:
            debuggee.check_stops([StopAt(mode, name, channel=channel)])
        except Failure as failure:
            found = failure.diagnostics[0]
            return {"dataId": None, "description": found.text(debuggee.language)}
        return {
            "dataId": data_id(mode, channel, name),
            "description": name,
            "accessTypes": ["write"],
            "canPersist": True,
        }

    def _breakpoint_locations(self, arguments: Arguments) -> Body:
        file = self._debuggee.sources.name_of(arguments.part("source"))
        if file is None:
            return {"breakpoints": []}
        first = arguments.number("line")
        places = self._debuggee.places(file).between(first, arguments.number("endLine", first))
        return {"breakpoints": [{"line": location.line} for location in places]}

    def _exception_info(self, _arguments: Arguments) -> Body:
        debuggee = self._debuggee
        if debuggee.fault is not None:
            return fault_info(debuggee.fault, debuggee.language)
        if debuggee.raised is None:
            raise Failure(diagnostic(UNKNOWN_REFERENCE, what="exception", number=0))
        return info(debuggee.raised, debuggee.report.kept, debuggee.language)

    # --- while running --------------------------------------------------------------------------

    def _thread(self, arguments: Arguments) -> int:
        return arguments.number("threadId", 1)

    def _continue(self, arguments: Arguments) -> Body:
        self._debuggee.check_paused("continue")
        thread = self._known_thread(arguments)
        self._then = lambda: self._debuggee.run(thread)
        return {"allThreadsContinued": True}

    def _pause(self, arguments: Arguments) -> Body:
        thread = self._thread(arguments)
        self._then = lambda: self._debuggee.pause(thread)
        return {}

    def _known_thread(self, arguments: Arguments) -> int:
        """Return the thread of a request; raises ``Failure`` for one that is not there."""
        thread = self._thread(arguments)
        self._debuggee.scopes.channel_of(thread)
        return thread

    def _is_tick(self, arguments: Arguments) -> bool:
        return arguments.text("granularity", "") == "instruction"

    def _step(self, command: str, arguments: Arguments, up: int | None) -> Body:
        debuggee = self._debuggee
        debuggee.check_paused(command)
        thread, is_tick = self._known_thread(arguments), self._is_tick(arguments)
        self._then = lambda: debuggee.step(thread, is_tick=is_tick, up=up)
        return {}

    def _step_back(self, arguments: Arguments) -> Body:
        debuggee = self._debuggee
        debuggee.check_paused("stepBack")
        thread, is_tick = self._known_thread(arguments), self._is_tick(arguments)
        self._then = lambda: debuggee.step_back(thread, is_tick=is_tick)
        return {}

    def _reverse_continue(self, arguments: Arguments) -> Body:
        debuggee = self._debuggee
        debuggee.check_paused("reverseContinue")
        thread = self._known_thread(arguments)
        self._then = lambda: debuggee.reverse(thread)
        return {}

    def _restart_frame(self, arguments: Arguments) -> Body:
        debuggee = self._debuggee
        debuggee.check_paused("restartFrame")
        channel, level = debuggee.scopes.program_of_frame(arguments.number("frameId"))
        self._then = lambda: debuggee.restart_frame(channel, level)
        return {}

    # --- looking --------------------------------------------------------------------------------

    def _threads(self, _arguments: Arguments) -> Body:
        return {"threads": self._debuggee.scopes.threads()}

    def _stack_trace(self, arguments: Arguments) -> Body:
        frames = self._debuggee.scopes.stack(self._thread(arguments))
        first = max(0, arguments.number("startFrame", 0))
        count = arguments.number("levels", 0) or MAX_FRAMES
        return {"stackFrames": frames[first : first + max(0, count)], "totalFrames": len(frames)}

    def _scopes(self, arguments: Arguments) -> Body:
        return {"scopes": self._debuggee.scopes.scopes(arguments.number("frameId"))}

    def _variables(self, arguments: Arguments) -> Body:
        reference = arguments.number("variablesReference")
        first, count = arguments.number("start", 0), arguments.number("count", 0)
        found = self._debuggee.scopes.variables(reference, max(0, first), max(0, count))
        return {"variables": found}

    def _set_variable(self, arguments: Arguments) -> Body:
        debuggee = self._debuggee
        reference, name = arguments.number("variablesReference"), arguments.text("name")
        found = debuggee.scopes.plc_variable(reference, name)
        if found is not None:
            return self._write_plc(found, arguments.text("value"))
        full, channel = debuggee.scopes.full_name(reference, name)
        return self._write(full, arguments.text("value"), channel)

    def _write_plc(self, found: PlcValue, text: str) -> Body:
        debuggee = self._debuggee
        debuggee.check_paused("setVariable")
        value = debuggee.scopes.plc.write(found, text)
        self._then = debuggee.note_input
        return {"value": value}

    def _set_expression(self, arguments: Arguments) -> Body:
        scopes, text = self._debuggee.scopes, arguments.text("expression")
        level = scopes.level_of(arguments.number("frameId", 0))
        channel = scopes.channel_of_frame(arguments.number("frameId", 0))
        if scopes.plc.is_there:
            try:
                found = scopes.plc.value(text, level)
            except Failure:
                if level is not None and not self._is_of_channel(text, channel):
                    raise
            else:
                return self._write_plc(found, arguments.text("value"))
        return self._write(text, arguments.text("value"), channel)

    def _write(self, name: str, text: str, channel: int) -> Body:
        debuggee = self._debuggee
        debuggee.check_paused("setVariable")
        value = debuggee.values.write(name, text, channel)
        self._then = debuggee.note_input
        return {"value": shown_value(value)}

    def _evaluate(self, arguments: Arguments) -> Body:
        debuggee = self._debuggee
        text = arguments.text("expression")
        in_plc = self._in_plc(arguments, text)
        if in_plc is not None:
            return in_plc
        channel = debuggee.scopes.channel_of_frame(arguments.number("frameId", 0))
        structure = debuggee.scopes.structure(text, channel)
        if structure is not None:
            return {
                "result": structure["value"],
                **{name: own for name, own in structure.items() if name not in ("name", "value")},
            }
        if arguments.text("context", "") != "repl":
            return {"result": debuggee.values.evaluate(text, channel), "variablesReference": 0}
        if debuggee.is_running and debuggee.console.travels(text):
            debuggee.check_paused(text.split()[0])
        tick = debuggee.session.tick
        try:
            with debuggee.session.together():
                answer = debuggee.console.run(text, channel)
        except Failure:
            if debuggee.session.tick != tick:  # interrupted on the way
                self._then = lambda: debuggee.report_travel("pause", channel)
            raise
        if answer.until:
            stop = read_stop(answer.until)
            debuggee.check_stops([stop])
            self._then = lambda: debuggee.run_until(stop, channel)
        elif answer.has_moved:
            self._then = lambda: debuggee.report_travel("goto", channel)
        else:
            self._then = debuggee.note_input
        return {"result": answer.text, "variablesReference": 0}

    def _in_plc(self, arguments: Arguments, text: str) -> Body | None:
        """Return the value of a variable in a call of the PLC, or of its path from elsewhere."""
        scopes = self._debuggee.scopes
        level = scopes.level_of(arguments.number("frameId", 0))
        is_console = arguments.text("context", "") == "repl"
        if not scopes.plc.is_there or (is_console and self._debuggee.console.is_command(text)):
            return None
        try:
            found = scopes.of_plc(scopes.plc.value(text, level), level)
        except Failure:
            channel = scopes.channel_of_frame(arguments.number("frameId", 0))
            if level is None or self._is_of_channel(text, channel):
                return None  # a name or an expression of the NC's language
            raise
        return {"result": found.pop("value"), **found}

    def _is_of_channel(self, text: str, channel: int) -> bool:
        """Return whether a channel has a value by a name or an expression."""
        if self._debuggee.scopes.structure(text, channel) is not None:
            return True
        try:
            self._debuggee.values.evaluate(text, channel)
        except Failure:
            return False
        return True

    def _completions(self, arguments: Arguments) -> Body:
        debuggee = self._debuggee
        text, column = arguments.text("text"), arguments.number("column")
        channel = debuggee.scopes.channel_of_frame(arguments.number("frameId", 0))
        return {"targets": debuggee.console.completions(text, column, channel)}

    def _loaded_sources(self, _arguments: Arguments) -> Body:
        return {"sources": self._debuggee.sources.all}

    def _source(self, arguments: Arguments) -> Body:
        sources = self._debuggee.sources
        asked = arguments.part("source")
        if not asked.has("path") and not asked.number("sourceReference", 0):
            asked = Arguments({"sourceReference": arguments.number("sourceReference", 0)})
        name = sources.name_of(asked)
        if name is None:
            raise Failure(diagnostic(NOT_IN_THE_RUN, file=asked.text("path", "–")))
        return {"content": "\n".join(sources.lines(name)), "mimeType": "text/plain"}
