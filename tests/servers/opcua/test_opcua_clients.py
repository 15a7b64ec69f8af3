# SPDX-License-Identifier: MIT
"""What a client of OPC UA sees and does: values, writes, methods, events, alarms, the past."""

from __future__ import annotations

import asyncio
from datetime import UTC, datetime, timedelta

import pytest

pytest.importorskip("asyncua", reason="needs the extra [opcua]")

from asyncua import ua
from support.opcua_client import patient_client
from support.served import Served, until

from nctakt.servers.opcua.model.types import all_components

pytestmark = pytest.mark.slow

CHANNEL = "ns=3;s=CncChannelList.1"
COUNT, VALUE, FLAG = (f"{CHANNEL}.V.E.{name}" for name in ("COUNT", "VALUE", "FLAG"))
INTERFACE = "ns=3;s=CncInterface"


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    """A server; each test leaves the session paused and without an error."""
    one = Served(tmp_path_factory.mktemp("served"))
    yield one
    one.close()


def run(served, work, language="en"):
    """Run a coroutine function with a connected client."""

    async def connected():
        client = patient_client(served.url)
        client.set_locale([language])
        async with client:
            await client.load_data_type_definitions()
            return await work(client)

    return asyncio.run(connected())


class Heard:
    """Keeps the notifications of a subscription."""

    def __init__(self):
        self.values = {}
        self.events = []

    def datachange_notification(self, node, value, data):
        """Keep a value."""
        self.values.setdefault(str(node), []).append(value)

    def event_notification(self, event):
        """Keep an event."""
        self.events.append(event)

    def status_change_notification(self, status):
        """Keep nothing."""


def restart(served, program="part.nc"):
    """Let the program begin anew: RESET, select, START; the session pauses after it."""
    served.session.pause()
    served.session.write({"HLI.RESET": 1, "V.E.FLAG": 0, "V.E.VALUE": 0, "HLI.FEED_HOLD": 0})
    served.session.step(200)
    served.session.select(served.folder / program)
    served.session.step(5)
    served.session.write({"HLI.START": 1})
    served.session.step(20)


@pytest.mark.nightly
def test_all_mandatory_components_are_there_with_a_value_or_not_supported(served):
    """Each object of the instance has what its type wants; nothing is silently 0."""
    restart(served)

    async def work(client):
        objects = {
            "CncAxisType": "CncAxisList.X",
            "CncSpindleType": "CncSpindleList.S",
            "CncChannelType": "CncChannelList.1",
        }
        statuses = {}
        for type_, path in objects.items():
            for component in all_components(type_):
                if component.rule != 78:
                    continue
                node = client.get_node(f"ns=3;s={path}.{component.name}")
                shown = await node.read_data_value(raise_on_bad_status=False)
                statuses[f"{path}.{component.name}"] = shown.StatusCode.name
                assert (await node.read_browse_name()) == ua.QualifiedName(component.name, 2)
        return statuses

    statuses = run(served, work)
    assert set(statuses.values()) == {"Good", "BadNotSupported"}
    for name in ("CncAxisList.X.ActLoad", "CncAxisList.X.ActTorque", "CncSpindleList.S.ActPower"):
        assert statuses[name] == "BadNotSupported"
    for name in ("CncAxisList.X.PosDirect", "CncSpindleList.S.ActSpeed", "CncAxisList.X.ActStatus"):
        assert statuses[name] == "Good"
    assert statuses["CncSpindleList.S.CmdOverride"] == "Good"


FUNCTIONS = """G01 X1 F6000
G04 X0.05
T1 G55 G91 G18 X1
G04 X0.05
G90 G92 X-3
G04 X0.05
M30
"""


def test_functions_offsets_and_the_tool_are_those_of_the_current_block(served):
    """Not those of the block that the decoder is at, several blocks ahead."""
    (served.folder / "functions.nc").write_text(FUNCTIONS, "utf-8")
    restart(served, "functions.nc")
    start = [1, 17, 71, 90, 162]
    shown = []

    async def work(client):
        async def value(path):
            return await client.get_node(f"ns=3;s={path}").read_value()

        names = [f"CncChannelList.1.{name}" for name in ("ActGFunctions", "ToolId")]
        names += ["CncChannelList.1.ActModalOffsetFunction", "CncAxisList.X.ZeroOffset"]
        line = "CncChannelList.1.ActProgramLine"
        while len(shown) < 3 and served.session.tick < 2000:
            served.session.step(5)
            if await value(line) == str(2 * len(shown) + 2):
                shown.append([await value(name) for name in names])

    run(served, work)
    assert shown[0] == [start, 0, 53, 0.0]
    assert shown[1] == [[1, 18, 55, 71, 91, 162], 1, 55, -50.0]
    assert shown[2] == [[1, 18, 55, 71, 90, 162], 1, 55, -53.0]


def test_values_are_those_of_the_session(served):
    """Positions with unit and range, feed, speed, program, states, turn direction."""
    restart(served)
    served.session.step(400)

    async def work(client):
        async def value(path):
            return await client.get_node(f"ns=3;s={path}").read_value()

        position = await value("CncAxisList.X.PosDirect")
        actual, to_go = served.session.read("X.ACS.CUR_POS", "X.MCS.DIST_TO_GO")
        assert (position.ActPos, position.RemDist) == (actual, to_go)
        assert await value("CncAxisList.X.PosDirect.ActPos") == actual
        assert (await value("CncAxisList.X.PosDirect.EngineeringUnits")).DisplayName.Text == "mm"
        limits = await value("CncAxisList.X.PosDirect.EURange")
        low, high = served.host.machine.axes[0].reachable
        assert (limits.Low, limits.High) == (low, high)
        (speed,) = served.session.read("PATH.SPEED")
        assert await value("CncChannelList.1.ActFeedrate") == pytest.approx(60 * speed)
        assert await value("CncChannelList.1.CmdFeedrate") == pytest.approx(6000)
        assert await value("CncSpindleList.S.CmdSpeed") == pytest.approx(1000)
        assert await value("CncSpindleList.S.ActTurnDirection") == 1
        assert await value("CncSpindleList.S.ActStatus") == 1
        assert await value("CncAxisList.X.IsVirtual") is True
        assert await value("CncChannelList.1.ActProgramStatus") == 1
        assert await value("CncChannelList.1.ActProgramName") == "part.nc"
        block = await value("CncChannelList.1.ActProgramBlock")
        assert block[1] == "N10 G01 X100 Y20 F6000"
        assert await value("CncAxisList.X.ActChannel") == ua.NodeId("CncChannelList.1", 3)

    run(served, work)


def test_a_write_is_seen_once_a_tick_has_latched_it(served):
    """Neither its own client nor another one sees it before."""
    restart(served)

    async def work(client):
        node = client.get_node(VALUE)
        await node.write_value(1.0)
        assert await node.read_value() == 0.0
        await asyncio.to_thread(served.session.step, 1)
        assert await node.read_value() == 1.0
        await asyncio.to_thread(served.session.step, 2)
        assert await client.get_node(COUNT).read_value() == 1
        fired = await until(lambda: read(client, f"{INTERFACE}.RealtimeCycles.1.Ran"))
        assert fired == 1
        assert await read(client, f"{INTERFACE}.RealtimeCycles.1.State") == "running"
        override = client.get_node("ns=3;s=CncSpindleList.S.CmdOverride")
        assert await override.read_value() == 100.0
        await override.write_value(80.0)
        await asyncio.to_thread(served.session.step, 2)
        assert await override.read_value() == 80.0
        await override.write_value(100.0)
        await asyncio.to_thread(served.session.step, 2)

    run(served, work)
    written = [one for one in served.session.tape() if one.values[:1] == ("V.E.VALUE",)]
    assert written[-1].source.startswith("opcua 127.0.0.1:")


async def read(client, node):
    """Return a value, or nothing as long as the node is not there."""
    shown = await client.get_node(node).read_data_value(raise_on_bad_status=False)
    return shown.Value.Value if shown.Value is not None else None


def test_wrong_writes_are_refused_with_their_reason(served):
    """Type, range, rights, unknown nodes; the log has client and reason."""
    restart(served)

    async def work(client):
        async def status(node, variant):
            request = ua.WriteValue(
                client.get_node(node).nodeid, ua.AttributeIds.Value, None, ua.DataValue(variant)
            )
            (answer,) = await client.uaclient.write(ua.WriteParameters([request]))
            return answer.name

        kinds = ua.VariantType
        assert await status(COUNT, ua.Variant(-1, kinds.Int32)) == "BadTypeMismatch"
        assert await status(VALUE, ua.Variant(float("nan"), kinds.Double)) == "BadOutOfRange"
        assert await status(VALUE, ua.Variant([1.0], kinds.Double)) == "BadTypeMismatch"
        name = "CncAxisList.X.PosDirect.ActPos"
        assert await status(f"ns=3;s={name}", ua.Variant(1.0, kinds.Double)) == "BadNotWritable"
        assert await status("i=2256", ua.Variant(1.0, kinds.Double)) == "BadNotWritable"
        assert await status("ns=3;s=nothing", ua.Variant(1.0, kinds.Double)) == "BadNodeIdUnknown"
        text = f"{CHANNEL}.V.E.TEXT"
        assert await status(text, ua.Variant("x" * 1000, kinds.String)) == "BadOutOfRange"

    run(served, work)
    assert any("wrong type" in reason for reason in served.refusals())


def test_values_come_at_the_clients_pace(served):
    """Changes come, unchanged values do not; a queue holds what lies between two publishings."""
    restart(served)

    async def work(client):
        heard = Heard()
        subscription = await client.create_subscription(50, heard)
        x = client.get_node("ns=3;s=CncAxisList.X.PosDirect.ActPos")
        z = client.get_node("ns=3;s=CncAxisList.Z.PosDirect.ActPos")
        await subscription.subscribe_data_change([x, z])
        await asyncio.to_thread(served.session.play, 1.0)
        await until(lambda: len(heard.values.get(str(x), ())) >= 5)
        await asyncio.to_thread(served.session.pause)
        assert heard.values[str(x)] == sorted(heard.values[str(x)])
        assert len(heard.values[str(z)]) == 1
        await subscription.delete()

    run(served, work)


def test_methods_run_a_program(served):
    """SelectProgram, Start, Stop, Continue, Reset; a refused one says why, in German, too."""
    served.session.pause()
    served.session.write({"HLI.RESET": 1})
    served.session.step(200)

    async def work(client):
        channel = client.get_node(CHANNEL)

        async def call(name, *words):
            method = client.get_node(f"{CHANNEL}.{name}")
            request = ua.CallMethodRequest(channel.nodeid, method.nodeid, list(words))
            (answer,) = await client.uaclient.call([request])
            reason = answer.OutputArguments[0].Value.Text if answer.OutputArguments else ""
            await asyncio.to_thread(served.session.step, 300)
            return answer.StatusCode.name, reason

        file = ua.Variant(str(served.folder / "part.nc"), ua.VariantType.String)
        assert await call("SelectProgram", file) == ("Good", "")
        assert await call("Start") == ("Good", "")
        assert served.session.latest.state == "running"
        assert await call("Stop") == ("Good", "")
        assert served.session.read("PATH.SPEED") == [0.0]
        assert await read(client, f"{CHANNEL}.ActProgramStatus") == 3
        assert await call("Continue") == ("Good", "")
        assert await call("Reset") == ("Good", "")
        assert served.session.latest.state != "running"
        nothing = ua.Variant(str(served.folder / "nothing.nc"), ua.VariantType.String)
        status, reason = await call("SelectProgram", nothing)
        assert status == "BadRequestNotAllowed"
        assert "nothing.nc" in reason
        outside = ua.Variant("/etc/passwd", ua.VariantType.String)
        assert (await call("SelectProgram", outside))[0] == "BadRequestNotAllowed"
        assert (await call("SelectProgram"))[0] == "BadArgumentsMissing"
        wrong = ua.Variant(1, ua.VariantType.Int32)
        assert (await call("SelectProgram", wrong))[0] == "BadInvalidArgument"

    run(served, work)


def test_messages_of_programs_are_events(served):
    """CncMessageType from the channel, also to those who listen to the server."""

    async def work(client):
        heard = Heard()
        subscription = await client.create_subscription(50, heard)
        type_ = client.get_node("ns=2;i=1011")
        await subscription.subscribe_events(client.nodes.server, type_)
        await asyncio.to_thread(restart, served)
        event = await until(lambda: [one for one in heard.events if one.Message.Text == "begun"])
        assert event[0].SourceNode == ua.NodeId("CncChannelList.1", 3)
        assert event[0].EventType == ua.NodeId(1011, 2)

    run(served, work)


def test_an_alarm_is_acknowledged_and_goes_with_reset(served):
    """Number, remedy in the client's language, states; refresh sends it to later subscribers."""

    async def work(client):
        heard = Heard()
        subscription = await client.create_subscription(50, heard)
        type_ = client.get_node("ns=2;i=1006")
        await subscription.subscribe_events(client.get_node(INTERFACE), type_)
        await asyncio.to_thread(restart, served, "wrong.nc")
        await asyncio.to_thread(served.session.step, 2000)
        alarm = (await until(lambda: heard.events))[0]
        assert served.session.read("HLI.ERROR") == [float(alarm.AlarmIdentifier)]
        assert getattr(alarm, "ActiveState/Id") is True
        assert getattr(alarm, "AckedState/Id") is False
        assert alarm.Retain is True
        assert alarm.AuxParameters[0].startswith("Eine Position zwischen den Grenzen")
        assert alarm.ActiveState.Text == "Aktiv"
        assert "wrong.nc:2" in alarm.AuxParameters[2]
        later = Heard()
        second = await client.create_subscription(50, later)
        await second.subscribe_events(client.get_node(INTERFACE), type_)
        condition_type = client.get_node("i=2782")
        refresh = client.get_node("i=3875")
        await condition_type.call_method(
            refresh, ua.Variant(second.subscription_id, ua.VariantType.UInt32)
        )
        await until(lambda: any(hasattr(one, "AlarmIdentifier") for one in later.events))
        comment = ua.Variant(ua.LocalizedText("gesehen", "de"), ua.VariantType.LocalizedText)
        event_id = ua.Variant(alarm.EventId, ua.VariantType.ByteString)
        condition = client.get_node(alarm.NodeId)
        await condition.call_method(client.get_node("i=9111"), event_id, comment)
        acked = await until(
            lambda: [one for one in heard.events if getattr(one, "AckedState/Id", False)]
        )
        assert acked[-1].Comment.Text == "gesehen"
        with pytest.raises(ua.UaStatusCodeError):
            await condition.call_method(client.get_node("i=9111"), event_id, comment)
        served.session.write({"HLI.RESET": 1})
        await asyncio.to_thread(served.session.step, 300)
        over = await until(lambda: [one for one in heard.events if one.Retain is False])
        assert getattr(over[-1], "ActiveState/Id") is False

    run(served, work, "de")


def test_the_past_of_a_signal_is_read(served):
    """Between two times, at most this many values, backward; at certain times."""
    restart(served)
    served.session.step(300)
    first, latest = served.session.tick - 200, served.session.tick

    async def work(client):
        node = client.get_node("ns=3;s=CncAxisList.X.PosDirect.ActPos")
        start = served.endpoint.space.clock.time(first)
        end = served.endpoint.space.clock.time(latest - 1)
        values = await node.read_raw_history(start, end)
        _, cells = served.session.look(first, latest, ["X.ACS.CUR_POS"], 200)
        assert [one.Value.Value for one in values] == list(cells)
        assert values[0].SourceTimestamp.replace(tzinfo=UTC) == start
        few = await node.read_raw_history(start, end, numvalues=10)
        assert [one.Value.Value for one in few] == list(cells)[:10]
        back = await node.read_raw_history(end, start, numvalues=5)
        assert [one.Value.Value for one in back] == list(cells)[:-6:-1]
        speed = client.get_node(f"{CHANNEL}.ActFeedrate")
        (value,) = await speed.read_raw_history(start, start + timedelta(microseconds=1))
        assert value.Value.Value == served.session.look(first, first + 1, ["PATH.SPEED"])[1][0] * 60
        text = client.get_node(f"{CHANNEL}.ActProgramName")
        with pytest.raises(ua.UaStatusCodeError):
            await text.read_raw_history(start, end)
        future = datetime.now(UTC) + timedelta(days=365)
        assert await node.read_raw_history(future, future + timedelta(seconds=1)) == []

    run(served, work)


def test_limits_are_reported(served):
    """In ServerCapabilities; intervals and queues are revised to what there is."""

    async def work(client):
        capabilities = ua.ObjectIds.Server_ServerCapabilities_OperationLimits_MaxNodesPerRead
        assert await client.get_node(ua.NodeId(capabilities)).read_value() == 10_000
        parameters = ua.CreateSubscriptionParameters(RequestedPublishingInterval=0.001)
        answer = await client.uaclient.create_subscription(parameters, lambda *_: None)
        assert answer.RevisedPublishingInterval == 10.0
        parameters = ua.CreateSubscriptionParameters(RequestedPublishingInterval=float("nan"))
        answer = await client.uaclient.create_subscription(parameters, lambda *_: None)
        assert answer.RevisedPublishingInterval == 50.0

    run(served, work)


def test_only_what_is_monitored_costs(served):
    """The session shows a value while somebody monitors it, and no longer."""
    served.session.pause()
    name = "A.OVERRIDE.VEL.TOTAL"
    store = served.host.store

    async def work(client):
        subscription = await client.create_subscription(50, Heard())
        node = client.get_node(f"{CHANNEL}.Signals.{name}")
        assert await node.read_value() == 100
        assert name not in store.values
        items = await subscription.subscribe_data_change([node, node])
        assert name in store.values
        await subscription.unsubscribe(items[0])
        assert name in store.values
        await subscription.unsubscribe(items[1])
        await until(lambda: name not in store.values)

    run(served, work)
