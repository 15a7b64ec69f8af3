# SPDX-License-Identifier: MIT
"""OPC UA for Machine Tools (OPC 40501-1): types as published, the machine as dashboards see it."""

from __future__ import annotations

import asyncio

import pytest

pytest.importorskip("asyncua", reason="needs the extra [opcua]")

from asyncua import ua
from support.opcua_client import patient_client
from support.published_model import machine_tool_node_set
from support.served import Served, until

from nctakt.servers.opcua.model.machine_tool import MACHINE_TOOL_URI, MACHINERY_URI

pytestmark = pytest.mark.slow

TOOL = "ns=3;s=MachineTool"
CHANNEL = f"{TOOL}.Monitoring.Channel_1"
STATE = f"{TOOL}.Production.ActiveProgram.State.CurrentState"
PARTS = f"{TOOL}.Production.Statistics.PartsProducedInLifetime"


@pytest.fixture
def served(tmp_path):
    """A server whose session pauses before the first tick."""
    one = Served(tmp_path)
    yield one
    one.close()


@pytest.fixture(scope="module")
def untouched(tmp_path_factory):
    """A server as it begins, for tests that only read: to build one takes seconds."""
    one = Served(tmp_path_factory.mktemp("untouched"))
    yield one
    one.close()


def run(served, work):
    """Run a coroutine function with a connected client."""

    async def connected():
        async with patient_client(served.url) as client:
            return await work(client)

    return asyncio.run(connected())


async def value(client, node):
    """Return the value of a node."""
    return await client.get_node(node).read_value()


def test_a_dashboard_finds_the_machine_by_browsing(untouched):
    """Objects / Machines / machine: the parts that are mandatory in 1.02 (8.1, 8.2)."""

    async def work(client):
        found = {}
        machinery = await client.get_namespace_index(MACHINERY_URI)
        machines = await client.nodes.objects.get_child(f"{machinery}:Machines")
        (machine,) = await machines.get_children()
        index = await client.get_namespace_index(MACHINE_TOOL_URI)
        assert await machine.read_type_definition() == ua.NodeId(13, index)
        for child in await machine.get_children():
            name = (await child.read_browse_name()).Name
            found[name] = {
                (await one.read_browse_name()).Name for one in await child.get_children()
            }
        return found

    found = run(untouched, work)
    assert set(found) == {
        "Identification",
        "Equipment",
        "Monitoring",
        "Production",
        "Notification",
        "Messages",  # as a notifier of events, too
    }
    assert {"Manufacturer", "ProductInstanceUri", "SerialNumber"} < found["Identification"]
    assert {"MachineTool", "Channel_1", "Spindle_S"} < found["Monitoring"]
    assert found["Production"] == {"ActiveProgram", "Statistics"}
    assert found["Notification"] == {"Messages"}


def test_state_and_parts_of_a_program(served):
    """Initializing 0, Running 1, Interrupted 3 by feed hold, Ended 2 with a part, Aborted 4."""
    seen = []

    async def look(client):
        texts = (await value(client, STATE)).Text, await value(client, f"{STATE}.Number")
        node = await value(client, f"{STATE}.Id")
        assert (await client.get_node(node).read_browse_name()).Name == texts[0]
        seen.append((*texts, await value(client, PARTS)))

    async def work(client):
        session = served.session
        await look(client)
        assert await value(client, f"{TOOL}.Production.ActiveProgram.Name") == "part.nc"
        assert await value(client, f"{CHANNEL}.ChannelState") == 0
        session.write({"HLI.START": 1})
        session.step(100)
        await look(client)
        session.write({"HLI.FEED_HOLD": 1})
        session.step(100)
        await look(client)
        assert await value(client, f"{CHANNEL}.ChannelState") == 1
        session.write({"HLI.FEED_HOLD": 0, "V.E.FLAG": 1, "HLI.OVERRIDE": 50})
        session.step(6000)
        await look(client)
        session.select(served.folder / "wrong.nc")
        session.step(5)
        await look(client)
        session.write({"HLI.START": 1})
        session.step(4000)
        await look(client)
        assert await value(client, f"{CHANNEL}.FeedOverride") == 50.0

    run(served, work)
    assert seen == [
        ("Initializing", 0, 0),
        ("Running", 1, 0),
        ("Interrupted", 3, 0),
        ("Ended", 2, 1),
        ("Initializing", 0, 1),
        ("Aborted", 4, 1),
    ]


def test_units_and_modes(untouched):
    """Overrides have unit and range; each signal with a unit has it as EngineeringUnits."""

    async def work(client):
        for node in (f"{CHANNEL}.FeedOverride", f"{TOOL}.Monitoring.Spindle_S.Override"):
            assert (await value(client, f"{node}.EngineeringUnits")).DisplayName.Text == "%"
            assert (await value(client, f"{node}.EURange")).Low == 0.0
        path = "ns=3;s=CncChannelList.1.Signals.PATH.SPEED.EngineeringUnits"
        assert (await value(client, path)).DisplayName.Text == "mm/s"
        assert await value(client, f"{TOOL}.Monitoring.MachineTool.OperationMode") == 1
        assert await value(client, f"{CHANNEL}.ChannelMode") == 0
        assert await value(client, f"{CHANNEL}.ChannelModifiers.SingleStep") is False
        assert await value(client, f"{TOOL}.Monitoring.Spindle_S.IsRotating") is False

    run(untouched, work)


def test_each_analog_leaf_has_its_unit(untouched):
    """OPC 10000-8, 5.3.2: analog items of the whole server, of both models, and of our signals.

    AnalogItemType, AnalogUnitType and AnalogUnitRangeType (ns 0: 2368, 17497, 17570).
    """
    analog = {2368: "EURange", 17497: "EngineeringUnits", 17570: "EURange"}

    async def below(node, seen):
        if node.nodeid in seen:
            return
        seen.add(node.nodeid)
        yield node
        for child in await node.get_children():
            async for one in below(child, seen):
                yield one

    async def work(client):
        found, wrong = 0, []
        async for node in below(client.nodes.objects, set()):
            if node.nodeid.NamespaceIndex == 0 or await node.read_node_class() != 2:
                continue
            kind = await node.read_type_definition()
            if kind.NamespaceIndex or kind.Identifier not in analog:
                continue
            found += 1
            names = {
                (await one.read_browse_name()).Name: one for one in await node.get_properties()
            }
            needed = {analog[kind.Identifier], "EngineeringUnits"}
            unit = names.get("EngineeringUnits")
            if not needed <= names.keys() or not (await unit.read_value()).DisplayName.Text:
                wrong.append(node.nodeid.to_string())
        return found, wrong

    found, wrong = run(untouched, work)
    assert not wrong, "\n".join(wrong)
    assert found > 20


class Heard:
    """Keeps the events of a subscription."""

    def __init__(self):
        self.events = []

    def event_notification(self, event):
        """Keep an event."""
        self.events.append(event)


def test_messages_and_alerts(served):
    """#MSG is an event of at most 333, an error an alert with ErrorCode above 666."""

    async def work(client):
        heard = Heard()
        subscription = await client.create_subscription(50, heard)
        index = await client.get_namespace_index(MACHINE_TOOL_URI)
        alert, event = ua.NodeId(39, index), ua.NodeId(35, index)
        await subscription.subscribe_events(f"{TOOL}.Notification.Messages", [alert, event])
        served.session.write({"HLI.START": 1})
        served.session.step(100)
        await asyncio.sleep(0.3)
        served.session.write({"HLI.RESET": 1})
        served.session.step(200)
        served.session.select(served.folder / "wrong.nc")
        served.session.step(5)
        served.session.write({"HLI.START": 1})
        served.session.step(4000)
        for _ in range(100):
            if any(getattr(one, "ErrorCode", None) for one in heard.events):
                break
            await asyncio.sleep(0.05)
        return heard.events, alert

    events, alert = run(served, work)
    message = next(one for one in events if one.Message.Text == "begun")
    assert message.Severity <= 333
    error = next(one for one in events if getattr(one, "ErrorCode", None) == "120002")
    assert error.EventType == alert
    assert 667 <= error.Severity <= 1000
    assert error.SourceName == "Messages"


@pytest.mark.nightly
def test_each_type_is_as_published(served, tmp_path_factory):
    """Names, and no reference to a type, rule or part that the published node has not."""
    published = machine_tool_node_set(tmp_path_factory.mktemp("npm"))
    space = served.endpoint.server.iserver.aspace
    index = served.endpoint.tool.indices.machine_tool
    own = [node for node in space.keys() if node.NamespaceIndex == index]
    assert len(own) > 50
    for node in own:
        one = published[f"ns=1;i={node.Identifier}"]
        named = space.read_attribute_value(node, ua.AttributeIds.BrowseName).Value.Value
        place, _, name = one.name.rpartition(":")
        assert (named.Name, named.NamespaceIndex) == (name, index if place == "1" else 0), node
        ours = {
            (forward.ReferenceTypeId.Identifier, forward.NodeId.Identifier)
            for forward in space[node].references
            if forward.IsForward and forward.ReferenceTypeId.Identifier in (37, 40, 41, 46, 47)
        }
        names = {"HasModellingRule": 37, "HasTypeDefinition": 40, "GeneratesEvent": 41}
        names |= {"HasProperty": 46, "HasComponent": 47}
        theirs = {
            (names[kind], int(target.rpartition("=")[2]))
            for kind, is_forward, target in one.references
            if is_forward and kind in names
        }
        assert ours <= theirs, (node, one.name)
        if one.kind == "UAVariable":
            assert space.read_attribute_value(node, ua.AttributeIds.AccessLevel).Value.Value == 1


def test_the_session_waits_for_nobody(served):
    """A program ends while no client is there: the part counts nevertheless."""
    served.session.write({"HLI.START": 1, "V.E.FLAG": 1})
    served.session.step(6000)
    asyncio.run(until(lambda: served.endpoint.tool.states.parts == 1))
