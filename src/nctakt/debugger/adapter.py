# SPDX-License-Identifier: MIT
"""The adapter: requests of the Debug Adapter Protocol -> answers and events.

In: messages of one client (``receive``, from the thread that reads them). Out: answers in the order
of the requests, events. One thread (``serve``) works on requests and, between them, on the run. A
client gets an answer to everything it sends: an impossible request is an error with its remedy.
A program continues from another block by a restart with block search; if that is impossible, the
present session stays.
"""

from __future__ import annotations

import os
import queue
import sys
import threading
import traceback
from collections.abc import Callable, Sequence
from typing import Any, Protocol

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Severity
from nctakt.base.failure import Failure, error_text
from nctakt.debugger.arguments import Arguments
from nctakt.debugger.breakpoints import MODES, Breakpoints
from nctakt.debugger.debuggee import Abilities, Debuggee
from nctakt.debugger.exceptions import ExceptionFilters, filters
from nctakt.debugger.launch import Configuration, read_configuration
from nctakt.debugger.relay import Relay, Relayed
from nctakt.debugger.requests import Requests
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import (
    GOTO_NEEDS_LAUNCH,
    NOT_LAUNCHED,
    PROGRAM_WITH_ERRORS,
    REQUEST_CANCELLED,
    TOO_MANY_REQUESTS,
)
from nctakt.messages.programs.block_search import START_BLOCK_NOT_REACHED
from nctakt.ports.framing import Message, MessageWriter
from nctakt.session.engine import StepResult
from nctakt.session.session import Session
from nctakt.session.stops import StopAt

#: Requests that wait at most.
MAX_REQUESTS = 256

#: How often the debugger checks what others do with their session, in seconds.
LOOK_S = 0.1

_CAPABILITIES = (
    "supportsConfigurationDoneRequest",
    "supportsFunctionBreakpoints",
    "supportsConditionalBreakpoints",
    "supportsHitConditionalBreakpoints",
    "supportsEvaluateForHovers",
    "supportsStepBack",
    "supportsSetVariable",
    "supportsCompletionsRequest",
    "supportsRestartRequest",
    "supportsExceptionInfoRequest",
    "supportsExceptionFilterOptions",
    "supportTerminateDebuggee",
    "supportsLoadedSourcesRequest",
    "supportsLogPoints",
    "supportsTerminateRequest",
    "supportsSetExpression",
    "supportsDataBreakpoints",
    "supportsCancelRequest",
    "supportsBreakpointLocationsRequest",
    "supportsClipboardContext",
    "supportsSteppingGranularity",
    "supportsRestartFrame",
    "supportsDisassembleRequest",
    "supportsGotoTargetsRequest",
)


class Enter(Protocol):
    """Admits a client of a port to a program, by the token; raises ``Failure``."""

    def __call__(self, token: str | None, request: str, *, is_open: bool) -> None:
        """``is_open``: the request needs no token."""


#: Requests that end the present activity, such as a search backward.
_ENDING = ("pause", "cancel", "terminate", "disconnect", "restart")


@dataclass(frozen=True, slots=True)
class Counting:
    """How a client counts lines and columns: from 1 on, as nctakt does, or from 0 on."""

    first_line: int = 1
    first_column: int = 1

    def outgoing(self, body: Any) -> Any:
        """Return a body of nctakt with lines and columns as the client counts them."""
        if self.first_line == 1 and self.first_column == 1:
            return body
        return _shifted(body, self.first_line - 1, self.first_column - 1)

    def incoming(self, body: Any) -> Any:
        """Return a body of the client with lines and columns counted from 1 on."""
        if self.first_line == 1 and self.first_column == 1:
            return body
        return _shifted(body, 1 - self.first_line, 1 - self.first_column)


class Adapter:
    """One client's debugger; ``folders``: the only ones whose files may be run.

    ``shared`` returns the session of somebody else, to which ``attach`` leads; it may change.
    ``enter``: admits a client of a port; ``None``: it has started this process.
    """

    def __init__(
        self,
        writer: MessageWriter,
        *,
        folders: Sequence[str] = (),
        language: Language = "en",
        shared: Callable[[], Session] | None = None,
        enter: Enter | None = None,
    ) -> None:
        self._enter_port = enter
        self._writer = writer
        self._folders = folders
        self._language: Language = language
        self._shared = shared
        self._queue: queue.Queue[Message | None] = queue.Queue()
        self._cancelled: set[int] = set()
        self._lock = threading.Lock()
        self._configuration: Configuration | None = None
        self._debuggee: Debuggee | None = None
        self._requests: Requests | None = None
        self._relay: Relay | None = None
        self._initialized: Any = None
        self._abilities = Abilities()
        self._counting = Counting()
        self._breakpoints = Breakpoints()
        self._exceptions = ExceptionFilters()
        self._is_closed = self._is_configured = False
        self._handlers: dict[str, Callable[[Arguments], dict[str, Any] | None]] = {
            "initialize": self._initialize,
            "launch": self._launch,
            "attach": self._attach,
            "restart": self._restart,
            "gotoTargets": self._goto_targets,
            "goto": self._goto,
            "configurationDone": self._configuration_done,
            "terminate": self._terminate,
            "disconnect": self._disconnect,
            "cancel": self._cancel,
        }

    # --- messages -------------------------------------------------------------------------------

    def receive(self, message: Message) -> None:
        """Take a message of the client, from the thread that reads."""
        if message.get("type") != "request":
            return
        if message.get("command") == "cancel":
            self._note_cancelled(message.get("arguments"))
        if message.get("command") in _ENDING and self._debuggee is not None:
            self._debuggee.session.interrupt()
        if self._queue.qsize() >= MAX_REQUESTS:
            self._answer_failure(message, [diagnostic(TOO_MANY_REQUESTS, limit=MAX_REQUESTS)])
            return
        self._queue.put(message)

    def refuse(self, failure: Failure) -> None:
        """Report to the client that its data is not a message of the protocol."""
        self.send_event("output", {"category": "important", "output": f"{failure}\n"})

    def end(self) -> None:
        """End: the client has gone; from the thread that reads."""
        self._queue.put(None)

    def _note_cancelled(self, arguments: object) -> None:
        number = arguments.get("requestId") if isinstance(arguments, dict) else None
        if isinstance(number, int):
            with self._lock:
                if len(self._cancelled) < MAX_REQUESTS:
                    self._cancelled.add(number)

    def _is_cancelled(self, number: object) -> bool:
        """Return whether the request of a number is cancelled, and forget that."""
        with self._lock:
            is_cancelled = isinstance(number, int) and number in self._cancelled
            if isinstance(number, int):
                self._cancelled.discard(number)
        return is_cancelled

    def send_event(self, event: str, body: dict[str, Any]) -> None:
        """Send an event."""
        self._writer.write({"type": "event", "event": event, "body": self._counting.outgoing(body)})

    def _answer(self, request: Message, body: dict[str, Any] | None) -> None:
        answer = _answer_to(request, is_success=True)
        if body is not None:
            answer["body"] = self._counting.outgoing(body)
        self._writer.write(answer)

    def _answer_failure(self, request: Message, diagnostics: Sequence[Diagnostic]) -> None:
        first = diagnostics[0]
        text = first.text(self._language)
        remedy = first.remedy(self._language)
        answer = _answer_to(request, is_success=False)
        answer["message"] = "cancelled" if first.message is REQUEST_CANCELLED else text
        shown = f"{first.headline(self._language)}\n{remedy}".replace("{", "(").replace("}", ")")
        answer["body"] = {"error": {"id": first.id, "format": shown, "showUser": True}}
        self._writer.write(answer)

    # --- the thread that works ------------------------------------------------------------------

    def serve(self) -> None:
        """Work on requests and on the run until the client goes."""
        try:
            while not self._is_closed and not self._writer.is_broken:
                debuggee = self._debuggee
                is_running = debuggee is not None and debuggee.is_running
                looks_s = LOOK_S if self._shared is not None and debuggee is not None else None
                try:
                    message = self._queue.get(block=not is_running, timeout=looks_s)
                except queue.Empty:
                    self._guarded(self._go_on)
                    continue
                if message is None:
                    break
                if self._relay is None:
                    self._work_on(message)
                else:
                    self._relay.send(message)
        finally:
            self._close()

    def _go_on(self) -> None:
        """Run for a short while, or watch what others do with their session."""
        debuggee = self._debuggee
        assert debuggee is not None
        if self._shared is not None and self._shared() is not debuggee.session:
            self._join(self._shared())
            return
        if debuggee.is_running:
            debuggee.go_on()
        else:
            debuggee.attend()

    def _guarded(self, work: Callable[[], None]) -> None:
        """Call ``work``; report an internal error, and pause the run."""
        try:
            work()
        except Exception as error:  # noqa: BLE001 - the debugger goes on
            self._report_internal(error)
            if self._debuggee is not None:
                self._debuggee.pause(1)

    def _work_on(self, message: Message) -> None:
        command = str(message.get("command"))
        if self._is_cancelled(message.get("seq")):
            self._answer_failure(message, [diagnostic(REQUEST_CANCELLED)])
            return
        try:
            if command == "initialize":
                self._initialized = message.get("arguments")
            arguments = Arguments(self._counting.incoming(message.get("arguments")))
            self._answer(message, self._handler(command)(arguments))
        except Relayed:
            assert self._relay is not None
            self._relay.send(message)
        except Failure as failure:
            self._answer_failure(message, failure.diagnostics)
            if self._requests is not None:
                self._guarded(self._requests.follow)
        except Exception as error:  # noqa: BLE001 - the debugger goes on
            answer = _answer_to(message, is_success=False)
            answer["message"] = error_text(error)
            self._writer.write(answer)
            self._report_internal(error)
        else:
            self._guarded(lambda: self._after(command))

    def _report_internal(self, error: Exception) -> None:
        self.send_event("output", {"category": "stderr", "output": f"{error_text(error)}\n"})
        if os.environ.get("NCTAKT_DEBUG"):
            traceback.print_exception(error, file=sys.stderr)

    def _handler(self, command: str) -> Callable[[Arguments], dict[str, Any] | None]:
        handler = self._handlers.get(command)
        if handler is not None:
            return handler
        requests = self._requests
        if requests is None:
            raise Failure(diagnostic(NOT_LAUNCHED, command=command))
        return lambda arguments: requests.answer(command, arguments)

    def _after(self, command: str) -> None:
        """Run the actions after the answer to a request."""
        debuggee, requests = self._debuggee, self._requests
        if debuggee is None or requests is None:
            return
        if command in ("launch", "attach"):
            self.send_event("initialized", {})
        if command == "goto":
            debuggee.report_travel("goto", 1)
        if command == "configurationDone" or (command == "restart" and self._is_configured):
            self._begin(debuggee)
        requests.follow()

    def _begin(self, debuggee: Debuggee) -> None:
        """Start the run, or stop before its first tick."""
        configuration = self._configuration
        if configuration is None:
            debuggee.stop_on_entry()  # somebody else's session is at rest
        elif not configuration.has_breakpoints:
            debuggee.session.set_stops()
            debuggee.run()
        elif configuration.stops_on_entry:
            debuggee.stop_on_entry()
        else:
            debuggee.run()

    # --- life -----------------------------------------------------------------------------------

    def _initialize(self, arguments: Arguments) -> dict[str, Any]:
        first_line = 1 if arguments.flag("linesStartAt1", True) else 0
        first_column = 1 if arguments.flag("columnsStartAt1", True) else 0
        self._counting = Counting(first_line, first_column)
        if arguments.text("locale", "").lower().startswith("de"):
            self._language = "de"
        self._abilities = Abilities(
            arguments.flag("supportsProgressReporting"),
            arguments.flag("supportsInvalidatedEvent"),
        )
        return {
            **dict.fromkeys(_CAPABILITIES, True),
            "exceptionBreakpointFilters": filters(self._language),
            "completionTriggerCharacters": [".", " "],
            "breakpointModes": [
                {"mode": mode, "label": label, "appliesTo": list(owners)}
                for mode, label, owners in MODES
            ],
        }

    def _enter(self, request: str, arguments: Arguments, *, is_open: bool) -> None:
        """Let a client of a port come in, with the token; raises ``Failure``, and leaves it."""
        if self._enter_port is None:
            return
        try:
            self._enter_port(arguments.optional_text("token"), request, is_open=is_open)
        except Failure:
            self._is_closed = True
            raise

    def _launch(self, arguments: Arguments) -> dict[str, Any]:
        self._enter("launch", arguments, is_open=bool(self._folders))
        configuration = read_configuration(arguments, self._folders)
        self._language = configuration.language or self._language
        self._open(configuration)
        return {}

    def _attach(self, arguments: Arguments) -> dict[str, Any] | None:
        """Join the session of ``nctakt live``, in this process or at a port."""
        self._enter("attach", arguments, is_open=False)
        self._leave()
        if self._shared is None:
            port = arguments.number("port")
            self._relay = Relay(port, self._initialized, self._writer, self.end)
            raise Relayed
        session = self._shared()
        session.pause()
        self._take(self._debug(session, stops_at_end=True, owns=False))
        return {}

    def _join(self, session: Session) -> None:
        """Go over to another session of the same page: its program was restarted."""
        self._leave()
        self._take(self._debug(session, stops_at_end=True, owns=False))
        if self._debuggee is not None:
            self._debuggee.stop_on_entry()

    def _open(self, configuration: Configuration) -> None:
        """Open a session; raises ``Failure`` where its programs do not run."""
        self._leave()
        session = configuration.open()
        found = session.description.diagnostics
        self._configuration = configuration
        try:
            debuggee = self._debug(session, stops_at_end=configuration.stops_at_end, owns=True)
        except BaseException:
            session.close()
            raise
        machine_note = configuration.settings.machine_note
        note = () if machine_note is None else (machine_note,)
        debuggee.report.diagnostics([*note, *found])
        if session.description.is_over:
            debuggee.close()
            errors = [one for one in found if one.severity is Severity.ERROR]
            first = errors[0].headline(self._language) if errors else ""
            program = configuration.program
            raise Failure(diagnostic(PROGRAM_WITH_ERRORS, program=program, first=first))
        self._take(debuggee)

    def _take(self, debuggee: Debuggee) -> None:
        self._debuggee = debuggee
        self._requests = Requests(debuggee)
        for shown in self._requests.verify_all():
            self.send_event("breakpoint", {"reason": "changed", "breakpoint": shown})

    def _debug(self, session: Session, *, stops_at_end: bool, owns: bool) -> Debuggee:
        return Debuggee(
            session,
            self._breakpoints,
            self._exceptions,
            self._language,
            self.send_event,
            self._abilities,
            owns=owns,
            stops_at_end=stops_at_end,
        )

    def _leave(self) -> None:
        """Leave the present session."""
        if self._debuggee is not None:
            self._debuggee.close()
            self._debuggee = self._requests = None

    def _restart(self, arguments: Arguments) -> dict[str, Any]:
        """Rerun the present programs from the start."""
        if self._configuration is None:
            raise Failure(diagnostic(NOT_LAUNCHED, command="restart"))
        changed = arguments.part("arguments")
        configuration = self._configuration
        if changed.has("program"):
            configuration = read_configuration(changed, self._folders)
        try:
            self._open(configuration)
        except Failure:
            self.send_event("terminated", {})
            raise
        return {}

    def _goto_targets(self, arguments: Arguments) -> dict[str, Any]:
        """Return the block in a line, if a block search can begin there."""
        debuggee, configuration = self._debuggee, self._configuration
        if debuggee is None:
            raise Failure(diagnostic(NOT_LAUNCHED, command="gotoTargets"))
        is_known = configuration is not None and bool(configuration.channels.get(1))
        found = start_block(debuggee, arguments) if is_known else None
        return {"targets": [] if found is None else [found]}

    def _goto(self, arguments: Arguments) -> dict[str, Any]:
        """Restart the first program at a block, by block search, and stop there."""
        debuggee, configuration = self._debuggee, self._configuration
        if debuggee is None or configuration is None:
            raise Failure(diagnostic(GOTO_NEEDS_LAUNCH))
        debuggee.check_paused("goto")
        session, done = search_block(debuggee, configuration, arguments.number("targetId"))
        self._leave()
        stops_at_end = configuration.stops_at_end
        self._take(self._debug(session, stops_at_end=stops_at_end, owns=True))
        assert self._debuggee is not None
        self._debuggee.report.news(done)
        return {}

    def _configuration_done(self, _arguments: Arguments) -> dict[str, Any]:
        if self._debuggee is None:
            raise Failure(diagnostic(NOT_LAUNCHED, command="configurationDone"))
        self._is_configured = True
        return {}

    def _terminate(self, _arguments: Arguments) -> dict[str, Any]:
        if self._debuggee is not None:
            self._debuggee.finish()
        return {}

    def _disconnect(self, _arguments: Arguments) -> dict[str, Any]:
        self._leave()
        self._is_closed = True
        return {}

    def _cancel(self, arguments: Arguments) -> dict[str, Any]:
        """Stop a run whose progress is shown; a request before this one has been answered."""
        self._is_cancelled(arguments.number("requestId", -1))
        if arguments.has("progressId") and self._debuggee is not None:
            self._debuggee.pause(1)
        return {}

    def _close(self) -> None:
        self._is_closed = True
        self._leave()
        if self._relay is not None:
            self._relay.close()


def _answer_to(request: Message, *, is_success: bool) -> Message:
    number = request.get("seq")
    return {
        "type": "response",
        "request_seq": number if isinstance(number, int) else 0,
        "success": is_success,
        "command": str(request.get("command")),
    }


_LINES = ("line", "endLine")
_COLUMNS = ("column", "endColumn", "start")


def _shifted(value: Any, lines: int, columns: int, depth: int = 0) -> Any:
    """Return a body whose lines and columns are counted from elsewhere."""
    if depth > 20:
        return value
    if isinstance(value, list):
        return [_shifted(item, lines, columns, depth + 1) for item in value]
    if not isinstance(value, dict):
        return value
    shifted = {}
    for name, item in value.items():
        if isinstance(item, int) and not isinstance(item, bool) and name in _LINES:
            shifted[name] = item + lines
        elif isinstance(item, int) and not isinstance(item, bool) and name in _COLUMNS:
            shifted[name] = item + columns
        else:
            shifted[name] = _shifted(item, lines, columns, depth + 1)
    return shifted


# --- another block to continue from ---------------------------------------------------------------


#: Machine time in which the start block becomes current, else the session stays before it.
LONGEST_APPROACH = "10 min"


def start_block(debuggee: Debuggee, arguments: Arguments) -> dict[str, Any] | None:
    """Return the block that a line begins, as a target; ``None`` if a search cannot end there."""
    file = debuggee.sources.name_of(arguments.part("source"))
    first = next(iter(debuggee.session.description.texts), None)
    line = arguments.number("line")
    if file is None or file != first:
        return None
    location = debuggee.places(file).at_or_after(line)
    if location is None or location.kind != "block" or location.line != line:
        return None
    return {"id": line, "label": debuggee.sources.line(file, line), "line": line}


def search_block(
    debuggee: Debuggee, configuration: Configuration, line: int
) -> tuple[Session, StepResult]:
    """Return a session at the block of a line, and how it has come there; raises ``Failure``."""
    file = next(iter(debuggee.session.description.texts), "")
    session = configuration.at_line(line).open()
    try:
        done = session.run(LONGEST_APPROACH, until=[StopAt("block", file=file, line=line)])
        if not done.hits:
            found = [*session.description.diagnostics, *done.diagnostics]
            errors = [one for one in found if one.severity is Severity.ERROR]
            missing = diagnostic(START_BLOCK_NOT_REACHED, block=str(line))
            raise Failure(*(errors or [missing]))
    except BaseException:
        session.close()
        raise
    return session, done
