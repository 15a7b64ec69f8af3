# SPDX-License-Identifier: MIT
"""The PLC of ../slow_plc.py in another process, through the HLI in shared memory.

In one shell: ``nctakt run examples/crossing.nc --hli cell_7``; in another one:
``python examples/hli/slow_plc.py cell_7``. It acknowledges each function after 200 ms; until then
the path runs at half speed.
"""

import sys

from nctakt import Failure, hli


def main(name: str) -> None:
    seen: set[int] = set()
    with hli.attach(name) as cell:
        for _ in cell.ticks():
            waiting = cell.functions()
            cell.override_pct = 50 if waiting else 100
            for function in waiting:
                if function.serial not in seen:
                    seen.add(function.serial)
                    x = cell.axis("X")["command"]
                    print(f"{function.time_us} us {function.name} X {x:.3f}")
                if cell.time_us - function.time_us >= 200_000:
                    cell.acknowledge(function)


try:
    main(sys.argv[1])
except Failure as failure:
    sys.exit(str(failure))
