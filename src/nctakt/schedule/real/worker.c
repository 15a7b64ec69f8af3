/* SPDX-License-Identifier: MIT */
/* The process of one thread of the list: it waits for its semaphore and uses the processor for the
 * times of the load, one call after another.
 *
 * Work is counted in the processor time of the thread, so that interruptions do not count.
 * The thread itself notices when it had the processor: where its clock jumps, something else ran.
 */
#define _GNU_SOURCE
#include "shared_area.h"

#include <errno.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <time.h>
#include <unistd.h>

/* From this jump of the clock on, in ns, something else had the processor. */
#define JUMP 10000
#define STACK 65536
#define PAGE 4096
/* Bytes of a log that are touched before the run, so that writing causes no page fault. */
#define TOUCHED 262144

static int64_t now_of(const struct area *area)
{
    return clock_ns(CLOCK_MONOTONIC) - area->origin;
}

static void log_entry(struct area *area, struct task *task, int kind, int64_t time, int64_t value,
                      int call)
{
    struct entry entry = {time, value, kind, (int32_t)task->number, call, sched_getcpu() + 1};
    write_entry(area, &task->log, entry);
}

/* Work for `length` ns from `now` on, with `rest` ns left afterwards; return when it is done. */
static int64_t work(struct area *area, struct task *task, int call, int64_t now, int64_t length,
                    int64_t rest)
{
    int64_t begin = now, last = now;
    int64_t end = clock_ns(CLOCK_THREAD_CPUTIME_ID) + length;
    for (;;) {
        int64_t left = end - clock_ns(CLOCK_THREAD_CPUTIME_ID);
        now = now_of(area);
        if (now - last > JUMP) {
            log_entry(area, task, ENTRY_SEGMENT, begin, last, call);
            begin = now;
        }
        last = now;
        atomic_store_explicit(&task->left, (left > 0 ? left : 0) + rest, memory_order_relaxed);
        if (left <= 0 || atomic_load_explicit(&area->stop, memory_order_relaxed))
            break;
    }
    log_entry(area, task, ENTRY_SEGMENT, begin, last, call);
    return last;
}

static void run_job(struct area *area, struct task *task, int64_t job)
{
    const int64_t *times = job_times(area, task, job);
    int64_t now = now_of(area), rest = job_length(area, task, job);
    atomic_store(&task->cpu_now, sched_getcpu() + 1);
    log_entry(area, task, ENTRY_WAKE, now, job, 0);
    for (int64_t i = 0; i < task->calls; i++) {
        rest -= times[i];
        now = work(area, task, (int)i, now, times[i], rest);
        if (atomic_load(&area->stop))
            _exit(0);
    }
    log_entry(area, task, ENTRY_END, now, job, 0);
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
