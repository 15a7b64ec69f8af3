# SPDX-License-Identifier: MIT
"""``nctakt serve``: a controller that clients find on the network, until it is ended.

In: programs, machine, PLC, endpoints. Out: a line with the addresses of all endpoints (standard
output), diagnostics (standard error), a log. It ends at SIGTERM and Ctrl-C.
"""

from __future__ import annotations

import contextlib
import json
import os
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Severity, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN
from nctakt.cli.common.help import NumberRange, described, option
from nctakt.cli.common.options import (
    MODE_OPTION,
    PACE_OPTION,
    TRUST_OPTION,
    table_options,
    take_words,
)
from nctakt.cli.common.request import STANDARD_INPUT, Options, Request, read_request
from nctakt.cli.common.running import choose_mode
from nctakt.cli.common.settings import carry_out
from nctakt.cli.common.tapes import inputs_of_run
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.lists.machine.files import machine_folder
from nctakt.messages import diagnostic
from nctakt.messages.connections.live import PAGE_NEEDS_FILES
from nctakt.messages.connections.opcua import OPCUA_LIBRARY_MISSING
from nctakt.messages.connections.servers import (
    ADS_NEEDS_SOURCES,
    INVALID_NET_ID,
    NO_ENDPOINT,
    PAGE_WITHOUT_PROGRAM,
    WHO_COMMANDS,
)
from nctakt.messages.files import FILE_NOT_WRITABLE
from nctakt.messages.scheduling.real_schedule import SPEED_OF_REAL_SCHEDULE
from nctakt.messages.scheduling.scheduled_runs import OPTION_WITHOUT_SCHEDULE
from nctakt.servers.serving import building

if TYPE_CHECKING:
    from nctakt.servers.serving import EndpointOpener
    from nctakt.session.growing_tape import GrowingTape
    from nctakt.session.session import Session
    from nctakt.session.setup import Setup
    from nctakt.st.program import Program


@described(
    "serve",
    summary=Text(
        "Serve ADS, OPC UA, MTConnect, MQTT for PLCs and HMIs.",
        "ADS, OPC UA, MTConnect, MQTT für SPS und HMI anbieten.",
    ),
    text=Text(
        "Serve a controller to PLCs and HMIs on the network: ADS, OPC UA, MTConnect, MQTT and a "
        "page in the browser.",
        "Eine Steuerung für SPS und HMI im Netz anbieten: ADS, OPC UA, MTConnect, MQTT und eine "
        "Seite im Browser.",
    ),
    codes=(
        Text("ended by Ctrl-C or SIGTERM", "beendet durch Strg-C oder SIGTERM"),
        Text(
            "programs with errors or a controller that has stopped",
            "Programme mit Fehlern oder eine Steuerung, die angehalten hat",
        ),
    ),
    notes=Text(
        'A line "ready" with the address of each protocol comes once clients can connect. They '
        "serve this computer alone, unless their address names another one.",
        'Eine Zeile "ready" mit der Adresse jedes Protokolls kommt, sobald sich Clients verbinden '
        "können. Sie bedienen nur diesen Rechner, außer ihre Adresse nennt einen anderen.",
    ),
    examples=(
        "nctakt serve --machine lists --ads",
        "nctakt serve part.nc --ads=0.0.0.0 --ads-from 192.168.0.0/24",
        "nctakt serve part.nc --opcua",
    ),
)
@table_options("serve")
@TRUST_OPTION
@option(
    "--ads",
    metavar="HOST:PORT",
    is_flag=False,
    flag_value="127.0.0.1:48898",
    group="protocols",
    text=Text(
        "Serve ADS [default address: 127.0.0.1:48898].",
        "ADS anbieten [Vorgabe der Adresse: 127.0.0.1:48898].",
    ),
)
@option(
    "--ads-net-id",
    metavar="NETID",
    group="protocols",
    text=Text(
        "NetId of the ADS server [default: that of its address, as 127.0.0.1.1.1].",
        "NetId des ADS-Servers [Vorgabe: die seiner Adresse, wie 127.0.0.1.1.1].",
    ),
)
@option(
    "--ads-from",
    "ads_networks",
    metavar="ADDRESS/NET",
    multiple=True,
    group="protocols",
    text=Text(
        "Take ADS connections from this address or network only; may be repeated [needed unless "
        "ADS is for this computer alone].",
        "ADS-Verbindungen nur von dieser Adresse oder aus diesem Netz annehmen; mehrfach möglich "
        "[nötig, außer ADS ist nur für diesen Rechner da].",
    ),
)
@option(
    "--ads-permit",
    "ads_permitted",
    metavar="NETID",
    multiple=True,
    group="protocols",
    text=Text(
        "Serve ADS only to clients that state this NetId; may be repeated [default: all].",
        "ADS nur Clients anbieten, die diese NetId angeben; mehrfach möglich [Vorgabe: allen].",
    ),
)
@option(
    "--live",
    metavar="HOST:PORT",
    is_flag=False,
    flag_value="127.0.0.1:8765",
    group="protocols",
    text=Text(
        "Show the run on a page in the browser [default address: 127.0.0.1:8765].",
        "Den Lauf auf einer Seite im Browser zeigen [Vorgabe der Adresse: 127.0.0.1:8765].",
    ),
)
@option(
    "--mtconnect",
    metavar="HOST:PORT",
    is_flag=False,
    flag_value="127.0.0.1:7878",
    group="protocols",
    text=Text(
        "Serve MTConnect agents [default address: 127.0.0.1:7878].",
        "MTConnect-Agents bedienen [Vorgabe der Adresse: 127.0.0.1:7878].",
    ),
)
@option(
    "--mqtt",
    metavar="URL",
    group="protocols",
    text=Text(
        "Tell an MQTT broker: mqtt://HOST[:PORT][/ROOT].",
        "Einem MQTT-Broker melden: mqtt://HOST[:PORT][/ROOT].",
    ),
)
@option(
    "--opcua",
    metavar="HOST:PORT",
    is_flag=False,
    flag_value="127.0.0.1:4840",
    group="protocols",
    text=Text(
        "Serve OPC UA [default address: 127.0.0.1:4840].",
        "OPC UA anbieten [Vorgabe der Adresse: 127.0.0.1:4840].",
    ),
)
@option(
    "--opcua-folder",
    metavar="FOLDER",
    default="opcua",
    group="protocols",
    text=Text(
        "Certificate and users of OPC UA for other addresses than this computer's own; the first "
        "start makes them [default: opcua].",
        "Zertifikat und Benutzer von OPC UA für andere Adressen als die dieses Rechners; der "
        "erste Start legt sie an [Vorgabe: opcua].",
    ),
)
@option(
    "--speed",
    type=NumberRange(0.01, 1000.0),
    default=1.0,
    metavar="F",
    text=Text(
        "Machine time runs F times as fast as the clock [default: 1].",
        "Die Maschinenzeit läuft F-mal so schnell wie die Uhr [Vorgabe: 1].",
    ),
)
@PACE_OPTION
@option(
    "--record",
    "tape",
    metavar="FILE",
    group="files",
    text=Text(
        "Record the inputs for nctakt replay, at the end.",
        "Die Eingaben für nctakt replay aufzeichnen, am Ende.",
    ),
)
@option(
    "--ready-file",
    metavar="FILE",
    group="files",
    text=Text(
        "Write the addresses to a file once clients can connect.",
        "Die Adressen in eine Datei schreiben, sobald sich Clients verbinden können.",
    ),
)
@option(
    "--log",
    metavar="FILE",
    group="files",
    text=Text(
        "Write what clients do as JSON lines, '-': to standard error.",
        "Schreiben, was Clients tun, als JSON-Zeilen, '-': auf die Standardfehlerausgabe.",
    ),
)
@MODE_OPTION
def command(**words: Any) -> int:
    """Serve a session."""
    serve_words = take_words(words, _Words)

    def show(options: Options, access: FileAccess) -> int:
        with building() as built:
            return _serve(options, access, serve_words, built)

    return carry_out({**words, "stays": True}, show)


@dataclass(frozen=True, slots=True)
class _Words:
    """The words that only this command has.

    ``ads_net_id``: of the ADS server, ``ads_permitted``: those of its clients, which connect from
    ``ads_networks``.
    """

    ads: str | None
    ads_net_id: str | None
    ads_networks: tuple[str, ...]
    ads_permitted: tuple[str, ...]
    live: str | None
    mtconnect: str | None
    mqtt: str | None
    opcua: str | None
    opcua_folder: str
    acknowledge: bool
    speed: float
    pace: str
    tape: str | None
    ready_file: str | None
    log: str | None

    @property
    def endpoints(self) -> dict[str, str | None]:
        """The words of the options of all endpoints but the page."""
        return {
            "ads": self.ads,
            "mtconnect": self.mtconnect,
            "mqtt": self.mqtt,
            "opcua": self.opcua,
        }


def _plc_programs(options: Options) -> Sequence[Program]:
    """Return the programs of PLCs in Structured Text; raises ``Failure``."""
    if not options.plcs:
        return ()
    from nctakt.plc.structured_text import structured_programs  # noqa: PLC0415 - rare

    return [program for one in options.plcs for program in structured_programs(one)]


def _serve(
    options: Options, access: FileAccess, serve_words: _Words, built: Callable[[], None]
) -> int:
    """Open the session and serve it, ``built`` once all endpoints are open.

    Raises ``Failure`` for unusable inputs.
    """
    _check_words(options, serve_words)
    choose_mode(options)
    import asyncio  # noqa: PLC0415 - no other command needs it

    from nctakt.lists.machine.machine import load_machine  # noqa: PLC0415 - the mode is chosen
    from nctakt.servers.log import ServerLog  # noqa: PLC0415 - as above
    from nctakt.servers.serving import serve  # noqa: PLC0415
    from nctakt.session.session import Session  # noqa: PLC0415

    request = read_request(options, access)
    folders = options.confined or served_folders(options)
    endpoints = _endpoints(serve_words)
    if serve_words.live is not None:
        endpoints["live"] = _page(options, serve_words, folders, serve_words.live)
    if not endpoints:
        raise Failure(diagnostic(NO_ENDPOINT))
    if not options.quiet:
        notes = [] if options.machine_note is None else [options.machine_note]
        print_diagnostics([*notes, *_who_commands(serve_words)], options.language)
    machine = load_machine(options.machine, access=access)
    _check_outputs(serve_words, access)
    with contextlib.ExitStack() as stack:
        log = ServerLog(stack.enter_context(_log_writer(serve_words.log)))
        setup = _setup(options, request, serve_words, folders)
        session = stack.enter_context(Session.of_setup(setup, serve_words.pace))
        lowest = Severity.ERROR if options.quiet else Severity.NOTE
        print_diagnostics(session.description.diagnostics, options.language, lowest)
        if session.is_over:
            return EXIT_NC_ERROR
        speed = serve_words.speed
        ready = _ready_teller(serve_words.ready_file, built)
        growing = _growing(serve_words.tape, session, setup, options, access)
        programs = _plc_programs(options)
        serving = serve(
            session,
            machine,
            log,
            endpoints,
            programs=programs,
            tape=growing,
            speed=speed,
            ready=ready,
        )
        try:
            asyncio.run(serving)
        finally:
            _end(session, options, serve_words.tape)
            if growing is not None:
                growing.close()
    return EXIT_RAN


def _check_words(options: Options, serve_words: _Words) -> None:
    """Raise ``Failure`` for options that do not fit each other."""
    if STANDARD_INPUT in (*options.programs, *(program for _, program in options.others)):
        raise Failure(diagnostic(PAGE_NEEDS_FILES))
    if options.rtconf is None and (options.load or options.system):
        option = "--load" if options.load else "--os"
        raise Failure(diagnostic(OPTION_WITHOUT_SCHEDULE, option=option))
    if options.rtconf is not None and serve_words.speed != 1.0:
        raise Failure(diagnostic(SPEED_OF_REAL_SCHEDULE))


def _check_outputs(serve_words: _Words, access: FileAccess) -> None:
    """Check that all outputs can be written, and remove an old ready file.

    Raises ``Failure`` for one that cannot be written, or that is an input.
    """
    with contextlib.ExitStack() as stack:  # each can be written, and is not one of the other files
        for option, file in (
            ("--record", serve_words.tape),
            ("--ready-file", serve_words.ready_file),
            ("--log", None if serve_words.log == "-" else serve_words.log),
        ):
            if file is not None:
                stack.enter_context(OutputFile(file, option, access))
    if serve_words.ready_file is not None and Path(serve_words.ready_file).is_file():
        Path(serve_words.ready_file).unlink()  # left by an earlier start: this one is not ready yet


def _setup(
    options: Options, request: Request, serve_words: _Words, folders: Sequence[str]
) -> Setup:
    """Return the setup of the session."""
    from nctakt.run.options import merged  # noqa: PLC0415 - the mode is chosen before
    from nctakt.session.setup import Setup  # noqa: PLC0415 - the mode is chosen before

    return Setup(
        {1: request.programs, **request.channels},
        options.machine,
        options.plcs,
        acknowledges=not serve_words.acknowledge,
        folders=folders,
        options=merged(request.session_options, {"stays": True}),
        rtconf=options.rtconf,
        load=options.load,
        system=options.system,
    )


def _endpoints(serve_words: _Words) -> dict[str, EndpointOpener]:
    """Return openers of the requested endpoints; raises ``Failure`` for wrong addresses."""
    endpoints: dict[str, EndpointOpener] = {}
    for name, word in serve_words.endpoints.items():
        if word is not None:
            endpoints[name] = _ENDPOINTS[name](word, serve_words)
    return endpoints


def _ads(word: str, serve_words: _Words) -> EndpointOpener:
    from nctakt.servers.address import (  # noqa: PLC0415 - only where it is asked for
        is_loopback,
        read_address,
        read_network,
    )
    from nctakt.servers.ads.server import PORT, AdsEndpoint  # noqa: PLC0415 - as above

    address = read_address("--ads", word, PORT)
    net_id = None if serve_words.ads_net_id is None else _net_id(serve_words.ads_net_id)
    clients = [_net_id(text) for text in serve_words.ads_permitted]
    networks = [read_network("--ads-from", text) for text in serve_words.ads_networks]
    if not networks and not is_loopback(address[0]):
        raise Failure(diagnostic(ADS_NEEDS_SOURCES, host=address[0]))
    return lambda host: AdsEndpoint(host, address, net_id, clients, networks)


def _net_id(text: str) -> bytes:
    """Return the bytes of a NetId; raises ``Failure`` (901476)."""
    from nctakt.servers.ads.frames import read_net_id  # noqa: PLC0415 - only where it is asked for

    found = read_net_id(text)
    if found is None:
        raise Failure(diagnostic(INVALID_NET_ID, text=text))
    return found


def _who_commands(serve_words: _Words) -> Iterator[Diagnostic]:
    """Yield a note for each endpoint that takes commands: from whom."""
    from nctakt.servers.address import is_loopback, read_address  # noqa: PLC0415 - as in _ads

    def is_local(endpoint: str) -> bool:
        return is_loopback(
            read_address(f"--{endpoint}", serve_words.endpoints[endpoint] or "", 0)[0]
        )

    local = Text(
        "any program of this computer, without a password",
        "jedes Programm dieses Rechners, ohne Passwort",
    )
    if serve_words.ads is not None:
        networks = ", ".join(serve_words.ads_networks)
        remote = Text(
            f"anyone who connects from {networks}, without a password",
            f"wer sich von {networks} verbindet, ohne Passwort",
        )
        yield diagnostic(WHO_COMMANDS, endpoint="ADS", who=remote if networks else local)
    if serve_words.opcua is not None:
        users = Text(
            f"the users of {serve_words.opcua_folder}",
            f"die Benutzer von {serve_words.opcua_folder}",
        )
        yield diagnostic(WHO_COMMANDS, endpoint="OPC UA", who=local if is_local("opcua") else users)
    if serve_words.mqtt is not None:
        writers = Text(
            "anyone who may write to the topics of the broker",
            "wer auf die Topics des Brokers schreiben darf",
        )
        yield diagnostic(WHO_COMMANDS, endpoint="MQTT", who=writers)


def _page(
    options: Options, serve_words: _Words, folders: Sequence[str], word: str
) -> EndpointOpener:
    """Return the function that opens the page; raises ``Failure`` (901477) without a program."""
    from nctakt.live.server import Reports, check_library  # noqa: PLC0415 - only where asked for

    check_library()
    from nctakt.live.document import Checker  # noqa: PLC0415 - as above
    from nctakt.live.endpoint import PageEndpoint  # noqa: PLC0415
    from nctakt.servers.address import read_address  # noqa: PLC0415

    address = read_address("--live", word, _PAGE_PORT)
    programs: dict[int, list[str]] = {1: list(options.programs)}
    for number, program in options.others:
        programs.setdefault(int(number), []).append(program)
    if not any(programs.values()):
        raise Failure(diagnostic(PAGE_WITHOUT_PROGRAM))
    checker = Checker(options.machine, folders)
    return lambda host: PageEndpoint(
        host.session,
        programs,
        checker,
        address,
        options.language,
        acknowledges=not serve_words.acknowledge,
        has_plc=bool(options.plcs),
        reports=Reports(
            lambda found: print_diagnostics([found], options.language),
            lambda client, reason: host.refuse_later("live", client, reason.get("en")),
        ),
    )


def _mtconnect(word: str, serve_words: _Words) -> EndpointOpener:
    from nctakt.servers.address import read_address  # noqa: PLC0415 - only where it is asked for
    from nctakt.servers.mtconnect import PORT, MtconnectEndpoint  # noqa: PLC0415 - as above

    address = read_address("--mtconnect", word, PORT)
    return lambda host: MtconnectEndpoint(host, address)


def _mqtt(word: str, serve_words: _Words) -> EndpointOpener:
    from nctakt.servers.mqtt import MqttEndpoint  # noqa: PLC0415 - only where it is asked for
    from nctakt.servers.mqtt_requests import read_broker  # noqa: PLC0415 - as above

    broker = read_broker(word)
    return lambda host: MqttEndpoint(host, broker)


def _opcua(word: str, serve_words: _Words) -> EndpointOpener:
    if find_spec("asyncua") is None:
        raise Failure(diagnostic(OPCUA_LIBRARY_MISSING))
    from nctakt.servers.address import read_address  # noqa: PLC0415 - only where it is asked for
    from nctakt.servers.opcua.endpoint import PORT, OpcuaEndpoint  # noqa: PLC0415 - as above

    address = read_address("--opcua", word, PORT)
    return lambda host: OpcuaEndpoint(host, address, Path(serve_words.opcua_folder))


#: The port of the page.
_PAGE_PORT = 8765

#: The option of each endpoint, and the function that opens it.
_ENDPOINTS: Mapping[str, Callable[[str, _Words], EndpointOpener]] = {
    "ads": _ads,
    "mtconnect": _mtconnect,
    "mqtt": _mqtt,
    "opcua": _opcua,
}


def served_folders(options: Options) -> tuple[str, ...]:
    """Return the folders whose files clients may select: of programs, machine and schedule.

    Without a program the working directory is one of them.
    """
    programs = (*options.programs, *(program for _, program in options.others))
    folders = {str(Path(program).parent): None for program in programs or ("./",)}
    if options.machine is not None:
        machine = Path(machine_folder(options.machine))
        folders[str(machine if machine.is_dir() else machine.parent)] = None
    schedule = (options.rtconf, options.load)
    folders.update((str(Path(file).parent), None) for file in schedule if file is not None)
    return tuple(folders)


@contextlib.contextmanager
def _log_writer(file: str | None) -> Iterator[Callable[[str], object] | None]:
    """Yield a function that writes a line of the log at once."""
    if file is None:
        yield None
    elif file == "-":
        yield lambda line: print(line, end="", file=sys.stderr, flush=True)
    else:
        with Path(file).open("wb", buffering=0) as stream:  # a full disk leaves nothing to flush
            yield lambda line: stream.write(line.encode())


def _ready_teller(
    file: str | None, built: Callable[[], None]
) -> Callable[[Mapping[str, str]], None]:
    """Return a function that reports the addresses of all endpoints, and that all are built."""

    def announce(addresses: Mapping[str, str]) -> None:
        built()
        if file is not None:
            document = {"process": os.getpid(), "addresses": dict(addresses)}
            with OutputFile(file, "--ready-file") as output:
                output.write(json.dumps(document) + "\n")
        shown = " ".join(f"{name}={address}" for name, address in addresses.items())
        click.echo(f"ready {shown}")
        sys.stdout.flush()

    return announce


def _growing(
    tape: str | None, session: Session, setup: Setup, options: Options, access: FileAccess
) -> GrowingTape | None:
    """Return the tape that grows meanwhile; ``None`` without a tape, and for a device or a pipe.

    Raises ``Failure`` (900507) if it cannot be written.
    """
    if tape is None or (Path(tape).exists() and not Path(tape).is_file()):
        return None
    from nctakt.session.growing_tape import GrowingTape  # noqa: PLC0415 - the mode is chosen

    try:
        return GrowingTape(tape, session, setup, dict(inputs_of_run(options, access)))
    except OSError as error:
        reason = error.strerror or str(error)
        raise Failure(diagnostic(FILE_NOT_WRITABLE, file=tape, reason=reason)) from error


def _end(session: Session, options: Options, tape: str | None) -> None:
    """Show the table of a real schedule; write the tape; raises ``Failure`` where it cannot be."""
    with contextlib.suppress(Failure):  # a lost controller has none, and its loss is reported
        click.echo(session.schedule_table(options.language), nl=False)
    if tape is not None:
        session.save(tape)
