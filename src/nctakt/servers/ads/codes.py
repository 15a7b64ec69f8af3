# SPDX-License-Identifier: MIT
"""The numbers of ADS: ports, commands, groups, errors, states (AD-1 … AD-5)."""

from __future__ import annotations

from enum import IntEnum

#: The TCP port of AMS.
TCP_PORT = 48898


class Port(IntEnum):
    """The ports of the controller's tasks (AD-2)."""

    GEO = 551
    SDA = 552
    COM = 553
    PLC = 851
    SYSTEM = 10000


class Command(IntEnum):
    """The commands of AMS (AD-1)."""

    DEVICE_INFO = 1
    READ = 2
    WRITE = 3
    READ_STATE = 4
    WRITE_CONTROL = 5
    ADD_NOTIFICATION = 6
    DELETE_NOTIFICATION = 7
    NOTIFICATION = 8
    READ_WRITE = 9


class Error(IntEnum):
    """The errors that clients get; those of a request as a whole are in its header."""

    NONE = 0
    INTERNAL = 0x1
    PORT_UNKNOWN = 0x6
    MACHINE_UNKNOWN = 0x7
    COMMAND_UNKNOWN = 0x8
    SERVICE = 0x701
    GROUP = 0x702
    OFFSET = 0x703
    ACCESS = 0x704
    SIZE = 0x705
    NOT_READY = 0x707
    BUSY = 0x708
    PARAMETER = 0x70B
    SYMBOL = 0x710
    NOTIFICATION_HANDLE = 0x714
    NO_HANDLES = 0x717


class Group(IntEnum):
    """The groups of symbols and sum commands (AD-3)."""

    HANDLE_BY_NAME = 0xF003
    VALUE_BY_NAME = 0xF004
    VALUE_BY_HANDLE = 0xF005
    RELEASE_HANDLE = 0xF006
    INFO_BY_NAME = 0xF007
    VERSION = 0xF008
    INFO_BY_NAME_EX = 0xF009
    UPLOAD = 0xF00B
    UPLOAD_INFO = 0xF00C
    TYPE_UPLOAD = 0xF00E
    UPLOAD_INFO_2 = 0xF00F
    TYPE_BY_NAME = 0xF011
    SUM_READ = 0xF080
    SUM_WRITE = 0xF081
    SUM_READ_WRITE = 0xF082
    SUM_READ_EX = 0xF083
    SUM_READ_EX_2 = 0xF084
    SUM_ADD_NOTIFICATION = 0xF085
    SUM_DELETE_NOTIFICATION = 0xF086
    DEVICE_DATA = 0xF100


class State(IntEnum):
    """The states of a device."""

    RESET = 2
    START = 4
    RUN = 5
    STOP = 6
    LOAD = 8
    ERROR = 11


class Transmission(IntEnum):
    """When a notification is sent."""

    CLIENT_CYCLE = 1
    CLIENT_ON_CHANGE = 2
    CYCLE = 3
    ON_CHANGE = 4


class AdsError(Exception):
    """A request that is refused; ``reason`` for the log, which has a line for each ``kind``."""

    def __init__(self, code: Error, reason: str = "", kind: str = "") -> None:
        super().__init__(code, reason)
        self.code = code
        self.reason = reason
        self.kind = kind or code.name.lower()
