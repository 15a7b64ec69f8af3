/* SPDX-License-Identifier: MIT */
/* The process of one thread of the list: it waits for its semaphore and works as long as the load
 * says, one call after another.
 *
 * Work is counted in the processor time of the thread, so that what interrupts it does not count.
 * When it had the processor is seen from inside: where its clock leaps, somebody else ran.
 */
#define _GNU_SOURCE
#include "processes.h"

#include <errno.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <time.h>
#include <unistd.h>

/* A leap of the clock, in ns, from which on somebody else had the processor. */
#define LEAP 10000
#define STACK 65536
#define PAGE 4096
/* So much of a log is touched before the run, that no page is missing in it. */
#define TOUCHED 262144

static int64_t now_of(const struct area *area)
{
    return clock_ns(CLOCK_MONOTONIC) - area->origin;
}

static void tell(struct area *area, struct task *task, int kind, int64_t time, int64_t value,
                 int call)
{
    struct entry entry = {time, value, kind, (int32_t)task->number, call, sched_getcpu() + 1};
    write_entry(area, &task->log, entry);
}

/* Work for `length` ns from `now` on, `rest` ns are left behind it; when that is done. */
static int64_t work(struct area *area, struct task *task, int call, int64_t now, int64_t length,
                    int64_t rest)
{
    int64_t begin = now, last = now;
    int64_t end = clock_ns(CLOCK_THREAD_CPUTIME_ID) + length;
    for (;;) {
        int64_t left = end - clock_ns(CLOCK_THREAD_CPUTIME_ID);
        now = now_of(area);
        if (now - last > LEAP) {
            tell(area, task, ENTRY_SEGMENT, begin, last, call);
            begin = now;
        }
        last = now;
        atomic_store_explicit(&task->left, (left > 0 ? left : 0) + rest, memory_order_relaxed);
        if (left <= 0 || atomic_load_explicit(&area->stop, memory_order_relaxed))
            break;
    }
    tell(area, task, ENTRY_SEGMENT, begin, last, call);
    return last;
}

static void run_job(struct area *area, struct task *task, int64_t job)
{
    const int64_t *times = job_times(area, task, job);
    int64_t now = now_of(area), rest = job_length(area, task, job);
    atomic_store(&task->cpu_now, sched_getcpu() + 1);
    tell(area, task, ENTRY_WAKE, now, job, 0);
    for (int64_t i = 0; i < task->calls; i++) {
        rest -= times[i];
        now = work(area, task, (int)i, now, times[i], rest);
        if (atomic_load(&area->stop))
            _exit(0);
    }
    tell(area, task, ENTRY_END, now, job, 0);
    atomic_fetch_sub(&task->busy, 1);
}

static void touch(struct area *area, struct task *task)
{
    volatile char stack[STACK];
    volatile char *log = AT(area, task->log.entries);
    int64_t size = task->log.capacity * (int64_t)sizeof(struct entry);
    for (int64_t i = 0; i < STACK; i += PAGE)
        stack[i] = 0;
    for (int64_t i = 0; i < size && i < TOUCHED; i += PAGE)
        log[i] = stack[0];
}

void run_worker(struct area *area, struct task *task, pid_t parent)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(0);
    /* Such signals may reach all processes of a terminal; the scheduler ends the run. */
    signal(SIGINT, SIG_IGN);
    signal(SIGHUP, SIG_IGN);
    signal(SIGTERM, SIG_IGN);
    signal(SIGCHLD, SIG_DFL);
    prctl(PR_SET_NAME, task->name);
    if (task->cpu != ANY_CPU)
        task->cpu_error = use_cpu((int)task->cpu);
    if (area->wants_fifo && area->fifo_error == 0)
        use_fifo((int)task->priority);
    else
        use_fifo(0);
    touch(area, task);
    atomic_fetch_add(&area->ready, 1);
    for (int64_t job = 0;; job++) {
        while (sem_wait(task->semaphore_address) != 0) {
        }
        if (atomic_load(&area->stop))
            _exit(0);
        run_job(area, task, job);
    }
}
