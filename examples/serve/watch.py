# SPDX-License-Identifier: MIT
"""A PLC program in Python: counts what the controller does, and holds the feed on a signal.

``nctakt serve examples/crossing.nc --ads``, then ``pip install pyads`` and
``python examples/serve/watch.py``.
"""

from datetime import datetime

import pyads


def note(handle: int, name: str, moment: datetime, value: int) -> None:
    """Print each change."""
    print(moment.time(), name, value)


plc = pyads.Connection("127.0.0.1.1.1", 851, "127.0.0.1")
with plc:
    print("X is at", plc.read_by_name("X.ACS.ACT_POS"), "mm")

    attributes = pyads.NotificationAttrib(4, pyads.ADSTRANS_SERVERONCHA)
    listener = plc.notification(pyads.PLCTYPE_UDINT)(note)
    handles = plc.add_device_notification("V.E.COUNT", attributes, listener)
    input("Enter holds the feed ")
    plc.write_by_name("HLI.FEED_HOLD", True, pyads.PLCTYPE_BOOL)
    input("Enter lets it go on ")
    plc.write_by_name("HLI.FEED_HOLD", False, pyads.PLCTYPE_BOOL)
    plc.del_device_notification(*handles)
