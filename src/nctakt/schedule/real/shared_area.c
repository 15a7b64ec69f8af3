/* SPDX-License-Identifier: MIT */
/* Common part of scheduler, workers and Python's threads: log, clock, job times, processors. */
#define _GNU_SOURCE

#include "shared_area.h"

#include <errno.h>
#include <sched.h>
#include <time.h>

int64_t clock_ns(int clock)
{
    struct timespec time;
    clock_gettime(clock, &time);
    return time.tv_sec * 1000000000LL + time.tv_nsec;
}

void write_entry(struct area *area, struct log *log, struct entry entry)
{
    int64_t count = atomic_load_explicit(&log->count, memory_order_relaxed);
    if (count >= log->capacity) {
        atomic_store(&area->is_full, 1);
        return;
    }
    ((struct entry *)AT(area, log->entries))[count] = entry;
    atomic_store_explicit(&log->count, count + 1, memory_order_release);
}

const int64_t *job_times(const struct area *area, const struct task *task, int64_t job)
{
    const int64_t *times = AT(area, task->times);
    return times + job % task->rows * task->calls;
}

int64_t job_length(const struct area *area, const struct task *task, int64_t job)
{
    const int64_t *times = job_times(area, task, job);
    int64_t length = 0;
    for (int64_t i = 0; i < task->calls; i++)
        length += times[i];
    return length;
}

int use_fifo(int priority)
{
    struct sched_param parameter = {.sched_priority = priority};
    return sched_setscheduler(0, priority ? SCHED_FIFO : SCHED_OTHER, &parameter) ? errno : 0;
}

int use_cpu(int cpu)
{
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(cpu - 1, &set);
    return sched_setaffinity(0, sizeof set, &set) ? errno : 0;
}
