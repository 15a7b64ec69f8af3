# SPDX-License-Identifier: MIT
"""A PLC that turns a spindle."""


class Plc:
    """Report the job and acknowledges it three ticks later."""

    def cycle(self, hli):
        for job in hli.spindle_jobs():
            hli.write("V.E.COUNT", job.function)
            hli.write("V.E.VALUE", job.speed)
            if hli.time_us - job.time_us >= 3_000:
                hli.acknowledge_spindle(job)
