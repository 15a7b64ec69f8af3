# SPDX-License-Identifier: MIT
"""The interface as the controller names it, on ADS: symbols, control units, errors (AD-3)."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from struct import calcsize, pack, unpack

from support.ads_wire import Bench, bench, by_name, data_of, number_of, read, result, write

from nctakt.hli.plc_entries import TechnologyEntry
from nctakt.hli.variables_memory import describe
from nctakt.servers.ads.codes import Error, Group

VALUE = Group.VALUE_BY_HANDLE


class Hmi:
    """A client that reads and writes elements by their paths."""

    def __init__(self, found: Bench) -> None:
        self.bench = found
        self._lane = found.connect()

    async def handle(self, path: str) -> int:
        """A handle of an element."""
        return number_of(await self.bench.ask(*self._lane, by_name(path)))

    async def get(self, path: str, form: str) -> float:
        """Its number."""
        handle = await self.handle(path)
        answer = await self.bench.ask(*self._lane, read(VALUE, handle, calcsize(f"<{form}")))
        return float(unpack(f"<{form}", data_of(answer))[0])

    async def bytes_of(self, path: str, size: int) -> bytes:
        """Its first bytes."""
        handle = await self.handle(path)
        return data_of(await self.bench.ask(*self._lane, read(VALUE, handle, size)))

    async def put(self, path: str, form: str, *values: object) -> int:
        """Write it; the error."""
        handle = await self.handle(path)
        data = pack(f"<{form}", *values)
        return result(await self.bench.ask(*self._lane, write(VALUE, handle, data)))

    async def refused(self, path: str, size: int) -> int:
        """The error of a read."""
        handle = await self.handle(path)
        return result(await self.bench.ask(*self._lane, read(VALUE, handle, size)))

    async def tick(self) -> None:
        """Run a tick, whose values come to the loop of the servers."""
        self.bench.session.advance()
        await asyncio.sleep(0.01)

    async def error(self, path: str) -> int:
        """The error of a handle that cannot be had."""
        return result(await self.bench.ask(*self._lane, by_name(path)))


def with_hmi(act: Callable[[Hmi, Bench], Awaitable[None]]) -> list[str]:
    """Let a client act; the lines of the server's log."""

    async def live() -> list[str]:
        async with bench() as found:
            await act(Hmi(found), found)
            return found.log

    return asyncio.run(live())


def test_positions_and_states_are_those_of_the_session_in_units_of_lists() -> None:
    """0.1 µm for positions, µm/s for feeds, TRUE or FALSE for conditions; with any spelling."""

    async def act(hmi: Hmi, found: Bench) -> None:
        found.session.written |= {"X.PCS.ACT_POS": 12.34567, "PATH.SPEED": 50.0, "HLI.STATE": 1.0}
        found.session.written |= {"X.STATE": 6.0, "S.SPEED": 100.0}
        await hmi.tick()
        path = "HLI_Global_Variables.gpCh[0]^.bahn_state"
        assert await hmi.get(f"{path}.coord_r[0].act_position_r", "i") == 123_457
        assert await hmi.get("gpch[0]^.BAHN_STATE.coord_r[0].state_r", "H") == 3
        assert await hmi.get("gpCh[0]^.bahn_state.active_feed_r", "i") == 50_000
        assert await hmi.get(f"{path}.program_end_r", "B") == 0
        assert await hmi.get("pMC[1]^.addr^.StateBahn_Data.X_ProgramEnd", "B") == 0
        assert await hmi.get("gpAx[4]^.lr_state.active_rev_r", "i") == 600_000
        assert await hmi.get("gpAx[1]^.head.log_ax_n_r", "H") == 2
        assert await hmi.get("HLI_Global_Constants.HLI_KEY_MAXIDX", "i") == 11
        assert (await hmi.bytes_of(f"{path}.coord_r[1].axis_name_r.zeichen", 16))[:2] == b"Y\0"

    with_hmi(act)


def test_a_control_unit_acts_for_a_plc_that_is_there_and_has_enabled_it() -> None:
    """enable_w FALSE: the HMI's request counts; TRUE: command_w; nothing without plc_present_w."""

    async def act(hmi: Hmi, found: Bench) -> None:
        found.session.written["HLI.OVERRIDE"] = 100.0
        unit = "gpCh[0]^.bahn_mc_control.override"
        assert await hmi.put(f"{unit}.command_w", "H", 800) == 0
        assert await hmi.put(f"{unit}.enable_w", "B", 1) == 0
        assert found.session.written["HLI.OVERRIDE"] == 100.0
        assert await hmi.put("gpCh[0]^.head.plc_present_w", "B", 1) == 0
        await hmi.tick()
        assert found.session.written["HLI.OVERRIDE"] == 80.0
        assert await hmi.get(f"{unit}.state_r", "H") == 800
        assert await hmi.get(f"{unit}.request_r", "H") == 1000
        assert await hmi.put(f"{unit}.state_r", "H", 1) == Error.ACCESS
        assert await hmi.put(f"{unit}.enable_w", "B", 0) == 0
        assert found.session.written["HLI.OVERRIDE"] == 100.0

    log = with_hmi(act)
    assert sum("plc_present_w of its area" in line for line in log) == 1


def test_an_edge_counts_once() -> None:
    async def act(hmi: Hmi, found: Bench) -> None:
        reset = "gpCh[0]^.channel_mc_control.reset"
        await hmi.put("gpCh[0]^.head.plc_present_w", "B", 1)
        await hmi.put(f"{reset}.enable_w", "B", 1)
        await hmi.put(f"{reset}.command_w", "B", 1)
        assert found.session.written.pop("HLI.RESET") == 1.0
        await hmi.put(f"{reset}.command_w", "B", 1)
        assert "HLI.RESET" not in found.session.written

    with_hmi(act)


def test_what_has_no_effect_is_kept_and_reported_once() -> None:
    async def act(hmi: Hmi, found: Bench) -> None:
        path = "gpAx[0]^.lr_mc_control.add_cmd_values.command_w"
        assert await hmi.put(path, "8i", 5, 6, 0, 0, 0, 0, 0, 0) == 0
        assert await hmi.get(f"{path}.m_add_speed_value", "i") == 6
        assert await hmi.put(path, "8i", 7, 6, 0, 0, 0, 0, 0, 0) == 0
        assert await hmi.get(f"{path}.m_add_pos_value", "i") == 7

    log = with_hmi(act)
    assert sum("m_add_pos_value" in line for line in log) == 1


def test_lengths_that_do_not_fit_and_paths_that_are_not_there_are_refused() -> None:
    async def act(hmi: Hmi, found: Bench) -> None:
        assert await hmi.put("gpCh[0]^.bahn_mc_control.override.command_w", "B", 1) == Error.SIZE
        assert await hmi.error("gpCh[0]^.bahn_state.programm_end_r") == Error.SYMBOL
        assert await hmi.error("gpCh[1]^.head.plc_present_w") == Error.SYMBOL
        assert await hmi.error("gpAx[0]^.lr_state.axis_state_r[2]") == Error.SYMBOL
        assert await hmi.refused("gpCh[0]^.bahn_state.covered_distance_r", 4) == Error.SERVICE
        assert await hmi.error("HLI_Global_Constants.HLI_NO_MAXIDX") == Error.SYMBOL

    log = with_hmi(act)
    assert any("nothing is called programm_end_r there" in line for line in log)


def test_the_operation_mode_manager_takes_a_transition_with_its_semaphore() -> None:
    """To ACTIVE with a program: it is selected, then started; the kernel clears the semaphore."""

    async def act(hmi: Hmi, found: Bench) -> None:
        unit = "gpCh[0]^.channel_mc_control.mode_and_state"
        await hmi.put("gpCh[0]^.head.plc_present_w", "B", 1)
        await hmi.put(f"{unit}.enable_w", "B", 1)
        # a client library that packs its structures leaves out the last byte
        assert await hmi.put(f"{unit}.command_w", "6I299s4x", 0, 0, 2, 4, 1, 0, b"part.nc") == 0
        assert await hmi.put(f"{unit}.command_semaphor_rw", "B", 1) == 0
        assert found.session.selected == [("part.nc", 1)]
        assert found.session.written["HLI.START"] == 1.0
        assert await hmi.get(f"{unit}.command_semaphor_rw", "B") == 0
        assert await hmi.get(f"{unit}.state_r.mode", "I") == 2
        found.session.written |= {"HLI.STATE": 1.0, "HLI.FEED_HOLD": 1.0}
        await hmi.tick()
        assert await hmi.get(f"{unit}.state_r.state", "I") == 5
        assert len(await hmi.bytes_of(f"{unit}.request_r", 327)) == 327

    with_hmi(act)


def test_an_error_is_new_until_its_reader_clears_the_semaphore() -> None:
    async def act(hmi: Hmi, found: Bench) -> None:
        found.session.written |= {"HLI.ERROR": 22009.0, "HLI.ERROR_SERIAL": 1.0}
        await hmi.tick()
        flag, number = (
            f"gpCh[0]^.mc_error.{one}" for one in ("semaphor_rw", "satz_r.kopf.error_id")
        )
        assert (await hmi.get(flag, "B"), await hmi.get(number, "I")) == (1, 22009)
        assert await hmi.put(flag, "B", 0) == 0
        assert await hmi.get(flag, "B") == 0
        found.session.written["HLI.ERROR_SERIAL"] = 2.0
        await hmi.tick()
        assert await hmi.get(flag, "B") == 1
        assert len(await hmi.bytes_of("gpCh[0]^.mc_error.satz_r", 942)) == 942

    with_hmi(act)


def test_external_variables_follow_their_pointers() -> None:
    """The packed memory of the lists (P-STUP-00145), GLOBAL and of the channel."""

    async def act(hmi: Hmi, found: Bench) -> None:
        machine = found.host.machine
        for channel, path in ((0, "gpVEGlob^"), (1, "HLI_Global_Variables.gpVECh[0]^")):
            field = next(one for one in describe(machine, channel) if one.type == "SGN32")
            name = f"V.E.{field.path}"
            found.session.written[name] = 4711.0
            await hmi.tick()
            size = field.offset + 4
            assert unpack("<i", (await hmi.bytes_of(path, size))[field.offset :]) == (4711,)

    with_hmi(act)


def test_functions_are_read_and_acknowledged_in_their_units() -> None:
    """please_rw is set with new data, the PLC clears it, done_w acknowledges; 1 M, 2 H, 4 T."""

    async def act(hmi: Hmi, found: Bench) -> None:
        first = TechnologyEntry("M", 100, 1, 0, False, 20_000.0, "", 0, 130, 7, "MVS_SVS")
        second = TechnologyEntry("H", 12, 2, 0, False, 0.0, "", 1, 0, 8, "MOS")
        of_axis = TechnologyEntry("M", 70, 3, 0, False, 0.0, "X", 2, 0, 9, "MOS")
        found.session.waiting += [(1, first), (1, second), (1, of_axis)]
        assert await hmi.get("gpCh[0]^.used_units_std_sync_r", "H") == 2
        unit = "gpCh[0]^.techno_unit_std_sync[0]"
        data = await hmi.bytes_of(unit, 48)
        assert unpack("<BBHiIiIIiHHI", data[:36]) == (
            *(1, 0, 1, 0),
            *(100, 20_000, 0, 0, 130, 0, 0, 2),
        )
        assert await hmi.put(f"{unit}.please_rw", "B", 0) == 0
        assert await hmi.get(f"{unit}.please_rw", "B") == 0
        assert await hmi.put("gpCh[0]^.techno_unit_std_sync[1].done_w", "B", 1) == 0
        assert found.session.waiting == [(1, first), (1, of_axis)]
        assert await hmi.get("gpCh[0]^.techno_unit_std_sync[1].type", "H") == 0
        assert await hmi.get("gpAx[0]^.used_units_std_sync_r", "H") == 1
        assert await hmi.put(f"{unit}.done_w", "B", 1) == 0
        assert await hmi.get("gpCh[0]^.used_units_std_sync_r", "H") == 0

    with_hmi(act)
