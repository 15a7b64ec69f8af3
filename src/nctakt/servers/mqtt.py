# SPDX-License-Identifier: MIT
"""The endpoint for MQTT: a broker gets changes of the session, which accepts writes from it.

In: frames and notices of the host; JSON on the topics ``write`` and ``press``. Out: JSON on topics
below a root: channels, axes, spindles, variables, texts, and an answer to each request. When the
broker is away, the session continues, and the endpoint reconnects.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import logging
import os
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, cast

from nctakt.base.failure import Failure, error_text
from nctakt.messages import diagnostic
from nctakt.messages.connections.servers import BROKER_NOT_REACHED, MQTT_NOT_INSTALLED
from nctakt.servers.address import shown_address
from nctakt.servers.hli_values import parts_of
from nctakt.servers.host import Busy, Host
from nctakt.servers.log import ServerLog, escaped
from nctakt.servers.mqtt_requests import (
    PASSWORD,
    REQUESTS,
    USER,
    Broker,
    RequestQueue,
    key_of,
    program_of,
    read_request,
    values_of,
)
from nctakt.servers.notices import ServerNotice, Subscription
from nctakt.servers.store import Scalar

if TYPE_CHECKING:
    import aiomqtt

#: The distance of two publications of changed values, in seconds.
_RATE_S = 0.1

#: The shortest and the longest time until the next attempt to connect, in seconds.
_FIRST_RETRY_S, _LAST_RETRY_S = 1.0, 30.0

#: How long a connection has to last for the next attempt to come soon again, in seconds.
_STEADY_S = 30.0

#: Bytes of a packet of a broker at most, and those that are read at once.
_MAX_PACKET, _PART = 16 << 20, 1 << 16

#: How long each of the two farewells to a broker may take, in seconds: it may hang.
_FAREWELL_S = 1.0

_ENDPOINT = "mqtt"
_AT_LEAST_ONCE = 1


class MqttEndpoint:
    """Publishes the state of a session below the root of its topics."""

    max_connections = 1

    def __init__(self, host: Host, broker: Broker) -> None:
        self._host = host
        self._broker = broker
        self._topics = _topics_of(host)
        self._task: asyncio.Task[None] | None = None
        # reports of the library about a broker go to nctakt's log, at a limited rate
        self._logger = logging.Logger("nctakt mqtt", logging.ERROR)
        self._logger.addHandler(_Unreadable(host.log, broker.host))

    async def prepare(self) -> None:
        """Ask for the values of all topics; raises ``Failure`` without the library (901452)."""
        if find_spec("aiomqtt") is None:
            raise Failure(diagnostic(MQTT_NOT_INSTALLED))
        await self._host.store.subscribe(
            name for names in self._topics.values() for name in names.values()
        )

    async def open(self) -> str:
        """Connect; return the address. Raises ``Failure`` if the broker cannot be reached."""
        import aiomqtt  # noqa: PLC0415 - an extra

        broker = self._broker
        try:
            client = await self._connected()
        except aiomqtt.MqttError as error:
            where = shown_address(broker.host, broker.port)
            raise Failure(diagnostic(BROKER_NOT_REACHED, broker=where, reason=error)) from error
        self._task = asyncio.create_task(self._live(client, (aiomqtt.MqttError, OSError)))
        return f"{shown_address(broker.host, broker.port)}/{broker.root}"

    async def close(self) -> None:
        """Inform the subscribers that the session has ended."""
        task, self._task = self._task, None
        if task is not None:
            task.cancel()
            await asyncio.gather(task, return_exceptions=True)

    def _waiting(self, maxsize: int) -> RequestQueue:
        """Return a queue for the requests of a new client, in place of the library's."""
        log, broker = self._host.log, self._broker
        return RequestQueue(broker.root, lambda reason: log.refuse(_ENDPOINT, broker.host, reason))

    def _client(self) -> aiomqtt.Client:
        """Return a client that is not connected yet; its end is reported by the broker."""
        import aiomqtt  # noqa: PLC0415 - an extra

        broker = self._broker
        client = aiomqtt.Client(
            broker.host,
            broker.port,
            username=os.environ.get(USER),
            password=os.environ.get(PASSWORD),
            tls_params=aiomqtt.TLSParameters() if broker.has_tls else None,
            will=aiomqtt.Will(f"{broker.root}/status", _json(online=False), 1, retain=True),
            timeout=_FIRST_RETRY_S * 5,
            logger=self._logger,
            queue_type=cast("type[asyncio.Queue[aiomqtt.Message]]", self._waiting),
        )
        # else a topic that is no UTF-8 ends its loop, whose socket stays open and busy forever
        client._client.suppress_exceptions = True
        _bound(client._client)
        return client

    async def _connected(self) -> aiomqtt.Client:
        """Return a client that has subscribed to requests: from now on none of them is lost."""
        client = self._client()
        await client.__aenter__()
        try:
            await self._publish(client, "status", _json(online=True), retain=True)
            for name in REQUESTS:
                await client.subscribe(f"{self._broker.root}/{name}", _AT_LEAST_ONCE)
            _end_if_cancelled()
        except BaseException as error:
            await client.__aexit__(type(error), error, None)
            raise
        return client

    async def _live(self, client: aiomqtt.Client, lost: tuple[type[Exception], ...]) -> None:
        """Serve connections in turn until the endpoint closes."""
        retry_s = _FIRST_RETRY_S
        is_connected = True
        loop = asyncio.get_running_loop()
        begin_s = loop.time()
        while True:
            try:
                if not is_connected:
                    client = await self._connected()
                    is_connected, begin_s = True, loop.time()
                self._host.log.note("connected", endpoint=_ENDPOINT, client=self._broker.host)
                # in a separate task: in Python before 3.13 a group that fails while it waits for
                # its tasks leaves the task around it cancelled
                await asyncio.create_task(self._serve(client))
            except lost as error:
                self._host.log.error("disconnected", endpoint=_ENDPOINT, reason=str(error))
            except Exception as error:  # noqa: BLE001 - one request must not end the endpoint
                self._host.log.error("disconnected", endpoint=_ENDPOINT, reason=error_text(error))
            finally:
                if is_connected:
                    is_connected = False
                    if loop.time() - begin_s >= _STEADY_S:
                        retry_s = _FIRST_RETRY_S
                    with contextlib.suppress(*lost):
                        await client.__aexit__(None, None, None)
            _end_if_cancelled()
            await asyncio.sleep(retry_s)
            retry_s = min(2.0 * retry_s, _LAST_RETRY_S)

    async def _serve(self, client: aiomqtt.Client) -> None:
        """Publish and answer until the connection ends."""
        is_full = asyncio.Event()
        notices = self._host.notices.subscribe(is_full.set)
        try:
            async with asyncio.TaskGroup() as group:
                group.create_task(self._publish_values(client))
                group.create_task(self._publish_notices(client, notices))
                group.create_task(_end_when(is_full))
                group.create_task(self._answer(client))
        except BaseExceptionGroup as several:
            raise several.exceptions[0] from None
        except asyncio.CancelledError:
            client.timeout = _FAREWELL_S
            await self._publish(client, "status", _json(online=False), retain=True)
            raise
        finally:
            self._host.notices.unsubscribe(notices)

    async def _publish(
        self, client: aiomqtt.Client, topic: str, text: str, *, retain: bool = False
    ) -> None:
        await client.publish(f"{self._broker.root}/{topic}", text, _AT_LEAST_ONCE, retain=retain)
        _end_if_cancelled()

    # --- reports --------------------------------------------------------------------------------

    async def _publish_values(self, client: aiomqtt.Client) -> None:
        """Publish each part whose values have changed, at most so often; the broker keeps them."""
        sent: dict[str, dict[str, Scalar]] = {}
        while True:
            tick, values = self._host.store.tick, self._host.store.values
            for topic, names in self._topics.items():
                shown = {
                    key: self._typed(name, values[name])
                    for key, name in names.items()
                    if name in values
                }
                if shown and sent.get(topic) != shown:
                    sent[topic] = shown
                    time_us = tick * self._host.cycle_time_us
                    time = self._host.clock.text(tick)
                    text = _json(tick=tick, time_us=time_us, time=time, **shown)
                    await self._publish(client, topic, text, retain=True)
            await asyncio.sleep(_RATE_S)

    def _typed(self, name: str, value: Scalar) -> Scalar:
        """Return a value as JSON has it: whole numbers, true and false by the type of the value."""
        host = self._host
        type_ = (host.marked.get(name) or host.catalogue.values[name]).type
        if isinstance(value, str) or type_ == "REAL64":
            return value
        return bool(value) if type_ == "BOOLEAN" else int(value)

    async def _publish_notices(self, client: aiomqtt.Client, notices: Subscription) -> None:
        while True:
            notice = await notices.next()
            await self._publish(client, "notice", _json(**self._notice_words(notice)))

    def _notice_words(self, notice: ServerNotice) -> dict[str, Any]:
        """Return a notice as JSON."""
        number = {"number": notice.diagnostic.id} if notice.diagnostic is not None else {}
        time = self._host.clock.text(notice.tick)
        return {
            "kind": notice.kind,
            "tick": notice.tick,
            "time": time,
            "text": notice.text,
            **number,
        }

    # --- requests -------------------------------------------------------------------------------

    async def _answer(self, client: aiomqtt.Client) -> None:
        """Carry out requests in turn; each gets an answer."""
        async for message in client.messages:
            topic = str(message.topic).removeprefix(f"{self._broker.root}/")
            payload = message.payload
            if message.retain:  # an old one, which would act again at each connection
                self._host.log.refuse(_ENDPOINT, self._broker.host, f"a retained {topic}")
                continue
            answer = await self._carry_out(topic, payload if isinstance(payload, bytes) else b"")
            await self._publish(client, "answer", _json(**answer))

    async def _carry_out(self, topic: str, payload: bytes) -> dict[str, Any]:
        """Return the answer to a request; a wrong one is refused."""
        client = self._broker.host
        try:
            request = read_request(payload)
        except ValueError as error:
            self._host.log.refuse(_ENDPOINT, client, f"{topic}: {error}")
            return {"ok": False, "text": str(error)}
        answer: dict[str, Any] = {"id": request["id"]} if "id" in request else {}
        try:
            if topic == "write":
                await self._host.write(values_of(request), _ENDPOINT, client)
            elif topic == "select":
                await self._host.select(
                    *program_of(request, len(self._host.machine.channels)), _ENDPOINT, client
                )
            else:
                await self._host.press(*key_of(request), _ENDPOINT, client)
        except Failure as failure:
            found = failure.diagnostics[0]
            return {**answer, "ok": False, "number": found.id, "text": found.text("en")}
        except Busy:
            return {**answer, "ok": False, "text": "too many writes wait"}
        except ValueError as error:
            self._host.log.refuse(_ENDPOINT, client, f"{topic}: {error}")
            return {**answer, "ok": False, "text": str(error)}
        return {**answer, "ok": True, "tick": self._host.store.tick}


class _Unreadable(logging.Handler):
    """Logs messages of a broker that the library could not read."""

    def __init__(self, log: ServerLog, broker: str) -> None:
        super().__init__(logging.ERROR)
        self._log = log
        self._broker = broker

    def emit(self, record: logging.LogRecord) -> None:
        """Take a record of the library."""
        self._log.refuse(_ENDPOINT, self._broker, "a message that cannot be read")


def _bound(library: Any) -> None:
    """Let the library end the connection of a broker that would fill its memory.

    It takes packets of any length, and keeps a message that is to come exactly once until the
    broker releases it; there are no subscriptions to those.
    """
    receive = library._sock_recv

    def received(size: int) -> bytes:
        if size > _MAX_PACKET or library._in_messages:
            raise ConnectionError("the broker sends messages without a subscription")
        return cast("bytes", receive(min(size, _PART)))

    library._sock_recv = received


def _end_if_cancelled() -> None:
    """Raise ``CancelledError`` in a task that somebody has cancelled.

    The library waits by ``asyncio.wait_for``, which loses a cancellation in Python 3.11 where the
    answer comes at the same time; a group of tasks loses it where one of them fails.
    """
    task = asyncio.current_task()
    if task is not None and task.cancelling():
        raise asyncio.CancelledError


async def _end_when(is_full: asyncio.Event) -> None:
    """Raise ``OSError`` once the broker has left too many notices unread."""
    await is_full.wait()
    raise OSError("the broker takes notices too slowly")


def _topics_of(host: Host) -> dict[str, dict[str, str]]:
    """Return the topics, each with its keys and the names of the session."""
    topics: dict[str, dict[str, str]] = {}
    for part in parts_of(host.machine, host.catalogue):
        if part.is_known:
            topics[f"{part.kind}/{part.name}"] = dict(part.names)
    for value in host.catalogue.values.values():
        if value.name.startswith("V.E.") or ".V.E." in value.name:
            topics[f"variable/{value.name}"] = {"value": value.name}
    for name in host.marked:
        topics[f"plc/{name}"] = {"value": name}
    return topics


def _json(**words: Any) -> str:
    return escaped(json.dumps(words, ensure_ascii=False))
