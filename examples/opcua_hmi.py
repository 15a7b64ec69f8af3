# SPDX-License-Identifier: MIT
"""An HMI in the browser that knows nothing but OPC UA: ``python opcua_hmi.py [URL [PORT]]``.

It finds axes, spindles and V.E variables by browsing the companion model for CNC, subscribes to
them at 50 ms, writes override and variables, calls the channel's methods, and shows alarms, which
an operator acknowledges. Needs asyncua and nicegui; start a controller before it, for example
``nctakt serve reactions.nc --opcua --wait-for-start``.
"""

from __future__ import annotations

import asyncio
import sys
from typing import Any

from asyncua import Client, Node, ua
from nicegui import app, ui

URL = sys.argv[1] if len(sys.argv) > 1 else "opc.tcp://127.0.0.1:4840/"
PORT = int(sys.argv[2]) if len(sys.argv) > 2 else 8090
CNC, OWN = "http://opcfoundation.org/UA/CNC", "urn:nctakt"
CHANNEL = (
    "ActProgramStatus",
    "ActProgramName",
    "ActProgramLine",
    "ActProgramBlock",
    "ActFeedrate",
    "CmdFeedrate",
    "CmdOverride",
)
PROGRAM_STATES = ("stopped", "running", "waiting", "interrupted", "canceled")


class Machine:
    """The controller behind the server: its values, as they come, and its alarms."""

    def __init__(self) -> None:
        self.client = Client(URL)
        self.values: dict[str, Any] = {}
        self.names: dict[str, str] = {}
        self.alarms: dict[str, Any] = {}
        self.axes: list[str] = []
        self.spindles: list[str] = []
        self.variables: dict[str, Node] = {}
        self.message = "connecting …"

    async def run(self) -> None:
        """Keep the connection; begin anew when it breaks."""
        while True:
            try:
                self.client = Client(URL)
                self.client.set_locale(["en"])
                async with self.client:
                    await self.find()
                    self.message = f"connected to {URL}"
                    while True:
                        await asyncio.sleep(1.0)
                        await self.client.check_connection()
            except (TimeoutError, ua.UaError, OSError) as error:
                self.message = f"no connection to {URL}: {error or 'time is over'}"
            await asyncio.sleep(1.0)

    async def find(self) -> None:
        """Browse the machine and subscribe to what the page shows."""
        client = self.client
        await client.load_data_type_definitions()
        cnc, own = [await client.get_namespace_index(uri) for uri in (CNC, OWN)]
        machine = await client.nodes.objects.get_child([f"{own}:CncInterface"])
        self.channel = (await (await machine.get_child([f"{cnc}:CncChannelList"])).get_children())[
            0
        ]
        nodes: dict[str, Node] = {}
        for list_, part, names in (
            ("CncAxisList", "PosDirect", self.axes),
            ("CncSpindleList", "ActSpeed", self.spindles),
        ):
            names.clear()
            for one in await (await machine.get_child([f"{cnc}:{list_}"])).get_children():
                names.append((await one.read_browse_name()).Name)
                nodes[names[-1]] = await one.get_child([f"{cnc}:{part}"])
        for name in CHANNEL:
            nodes[name] = await self.channel.get_child([f"{cnc}:{name}"])
        folder = await self.channel.get_child([f"{own}:V.E"])
        for node in await folder.get_children():
            self.variables[(await node.read_browse_name()).Name] = node
        shown = [name for name in self.variables if "[" not in name and "." not in name]
        nodes |= {f"V.E.{name}": self.variables[name] for name in shown}
        self.names = {node.nodeid.to_string(): name for name, node in nodes.items()}
        subscription = await client.create_subscription(50, self)
        await subscription.subscribe_data_change(list(nodes.values()))
        alarm = client.get_node(ua.NodeId(1006, cnc))
        await subscription.subscribe_events(machine, alarm)
        refresh = client.get_node(ua.NodeId(ua.ObjectIds.ConditionType_ConditionRefresh))
        number = ua.Variant(subscription.subscription_id, ua.VariantType.UInt32)
        condition = client.get_node(ua.NodeId(ua.ObjectIds.ConditionType))
        await condition.call_method(refresh, number)

    def datachange_notification(self, node: Node, value: Any, data: Any) -> None:
        """Take a value."""
        self.values[self.names[node.nodeid.to_string()]] = value

    def event_notification(self, event: Any) -> None:
        """Take an alarm; one that is over goes."""
        number = getattr(event, "AlarmIdentifier", None)
        if number is not None:
            key = event.NodeId.to_string()
            self.alarms.pop(key, None)
            if event.Retain:
                self.alarms[key] = event

    def status_change_notification(self, status: Any) -> None:
        """Show that the subscription has ended."""
        self.message = f"the subscription has ended: {status}"

    async def do(self, work: Any) -> None:
        """Await what an operator wants, and show why it was refused."""
        try:
            await work
            self.message = "done"
        except ua.UaError as error:
            self.message = f"refused: {error}"

    async def call(self, name: str, *words: Any) -> None:
        """Call a method of the channel."""
        index = await self.client.get_namespace_index(OWN)
        await self.do(self.channel.call_method(f"{index}:{name}", *words))

    async def write(self, node: Node, value: Any) -> None:
        """Write a value in the type of its node."""
        kind = await node.read_data_type_as_variant_type()
        value = value if kind == ua.VariantType.String else float(value)
        if kind not in (ua.VariantType.String, ua.VariantType.Double):
            value = bool(value) if kind == ua.VariantType.Boolean else int(value)
        await self.do(node.write_value(ua.Variant(value, kind)))

    async def set_override(self, percent: float) -> None:
        """Write the operator's override."""
        index = await self.client.get_namespace_index(CNC)
        node = await self.channel.get_child([f"{index}:CmdOverride"])
        await self.write(node, percent)

    async def acknowledge(self, key: str) -> None:
        """Acknowledge an alarm."""
        event = self.alarms[key]
        node = self.client.get_node(event.NodeId)
        method = ua.NodeId(ua.ObjectIds.AcknowledgeableConditionType_Acknowledge)
        words = [
            ua.Variant(event.EventId, ua.VariantType.ByteString),
            ua.Variant(ua.LocalizedText("HMI", "en"), ua.VariantType.LocalizedText),
        ]
        await self.do(node.call_method(method, *words))


machine = Machine()
app.on_startup(lambda: asyncio.create_task(machine.run()))


@ui.page("/")
def page() -> None:
    """Show the machine."""
    ui.page_title("HMI")
    with ui.row().classes("w-full items-start"):
        with ui.card():
            ui.label("Axes").classes("text-lg")
            positions = ui.table(
                columns=[
                    {"name": name, "label": name, "field": name, "align": "right"}
                    for name in ("axis", "actual", "command", "to go")
                ],
                rows=[],
                row_key="axis",
            ).props("dense flat")
        with ui.card():
            ui.label("Channel").classes("text-lg")
            state, feed = ui.label().mark("state"), ui.label()
            block = ui.label().classes("font-mono whitespace-pre")
            with ui.row():
                for name in ("Start", "Stop", "Continue", "Reset"):
                    ui.button(name, on_click=lambda name=name: machine.call(name))
            program = ui.input("Program")
            ui.button("Select", on_click=lambda: machine.call("SelectProgram", program.value))
            ui.label("Override in %")
            ui.slider(
                min=0, max=150, value=100, on_change=lambda e: machine.set_override(e.value)
            ).props("label")
        with ui.card():
            ui.label("V.E variables").classes("text-lg")
            variable = ui.input("Name", value="VALUE")
            value = ui.number("Value", value=1)
            ui.button(
                "Write",
                on_click=lambda: machine.write(machine.variables[variable.value], value.value),
            )
            variables = ui.label().classes("font-mono whitespace-pre")
    ui.label("Alarms").classes("text-lg")
    alarms = ui.column()
    message = ui.label()
    shown: list[tuple[str, bool]] = []

    def show() -> None:
        values = machine.values
        positions.rows = [
            {
                "axis": axis,
                "actual": f"{values[axis].ActPos:.3f}",
                "command": f"{values[axis].CmdPos:.3f}",
                "to go": f"{values[axis].RemDist:.3f}",
            }
            for axis in machine.axes
            if values.get(axis) is not None
        ]
        status = values.get("ActProgramStatus")
        word = "" if status is None else PROGRAM_STATES[status]
        state.text = f"{values.get('ActProgramName') or '–'}: {word}"
        feed.text = (
            f"feed {values.get('ActFeedrate') or 0:.0f} of {values.get('CmdFeedrate') or 0:.0f}"
            f" mm/min, override {values.get('CmdOverride') or 0:.0f} %"
        )
        block.text = "\n".join(values.get("ActProgramBlock") or ["", "", ""])
        variables.text = "\n".join(
            f"{key:<20}{shown_value}" for key, shown_value in values.items() if key[:4] == "V.E."
        )
        message.text = machine.message
        known = [(key, getattr(one, "AckedState/Id")) for key, one in list(machine.alarms.items())]
        if known != shown:
            shown[:] = known
            show_alarms()

    def show_alarms() -> None:
        alarms.clear()
        with alarms:
            for key, is_acked in shown:
                event = machine.alarms[key]
                with ui.row().classes("items-center"):
                    ui.label(f"{event.AlarmIdentifier}: {event.Message.Text}")
                    ui.label(event.AuxParameters[0]).classes("text-gray-600")
                    if not is_acked:
                        ui.button("Acknowledge", on_click=lambda key=key: machine.acknowledge(key))

    ui.timer(0.1, show)


if __name__ in ("__main__", "__mp_main__"):
    ui.run(host="127.0.0.1", port=PORT, reload=False, show=False, title="HMI")
