/* SPDX-License-Identifier: MIT */
/* The memory that Python, the scheduler and the workers share; area.py has the same layout.
 *
 * Times are ns since `origin`, which is a moment of CLOCK_MONOTONIC; offsets are bytes from the
 * start of the area. Each log has one writer. What several processes touch is atomic.
 */
#ifndef NCTAKT_PROCESSES_H
#define NCTAKT_PROCESSES_H

#include <semaphore.h>
#include <stdatomic.h>
#include <stdint.h>
#include <sys/types.h>

#define NAME_SIZE 256
#define ANY_CPU 0

enum task_kind { REALTIME, ASYNCHRONOUS, EXTERNAL };
enum overflow_policy { SKIP, PEND, QUEUE };

/* What a log says: time, value, call, cpu. */
enum entry_kind {
    ENTRY_INTERRUPT, /* when the scheduler handled it, when it should have come */
    ENTRY_POINT,     /* the same of the point of suspension */
    ENTRY_RELEASE,   /* the job's number; call 1: it waits behind another one */
    ENTRY_OVERFLOW,  /* the work left; call 1: the activation is remembered */
    ENTRY_SUSPEND,   /* the work left */
    ENTRY_RESUME,    /* the work left */
    ENTRY_WAKE,      /* the job's number */
    ENTRY_SEGMENT,   /* from time to value the call ran on cpu (from 1) */
    ENTRY_END,       /* the job's number */
};

/* How a run ended. */
enum status { RUNNING, DONE, STOPPED, LOG_FULL, NO_SEMAPHORE, NO_PROCESS, PROCESS_ENDED };

struct entry {
    int64_t time, value;
    int32_t kind, task, call, cpu;
};

struct log {
    int64_t entries, capacity; /* offset of the first one, how many there is room for */
    _Atomic int64_t count;
};

struct task {
    char name[16];
    char semaphore[NAME_SIZE];  /* of an external thread, with its slash */
    int64_t number;             /* its place in the model */
    int64_t kind;
    int64_t has_process;        /* 0: somebody else's process waits on the semaphore */
    int64_t every;
    int64_t cpu;                /* from 1 */
    int64_t priority;           /* of SCHED_FIFO */
    int64_t calls, rows, times; /* rows of execution times, one for each call */
    int64_t due, max_jobs;     /* when each job was due */
    struct log log;
    /* Written while it runs. */
    int64_t pid, jobs, is_suspended, wakes;
    int64_t cpu_error, waiting_at_end;
    _Atomic int64_t busy;       /* jobs that are not finished */
    _Atomic int64_t left, cpu_now;
    union {
        sem_t wake;
        int64_t room[8];
    };
    sem_t *semaphore_address;
};

struct area {
    int64_t task_count, tasks;  /* the most urgent task first */
    int64_t cycles, moments;    /* when each NC interrupt comes, the one at the end too */
    int64_t limit;              /* a semaphore's interrupts are awaited so long */
    int64_t cycle, slice, windows, elapsed, phase;
    int64_t windows_cpus;       /* bit c-1 for CPU c */
    int64_t policy;
    int64_t wants_fifo;
    int64_t from_semaphore;
    char source[NAME_SIZE];     /* the semaphore that gives NC interrupts */
    char record[NAME_SIZE];     /* the file that names what must not stay behind */
    struct log log;
    /* Written while it runs. */
    int64_t origin, fifo_error, status, status_task, status_number, is_clean;
    int64_t drained;            /* posts of the source from before the start */
    int64_t end;                /* when the last cycle was left */
    _Atomic int64_t ready, stop, is_full;
};

#define AT(area, offset) ((void *)((char *)(area) + (offset)))

void run_scheduler(struct area *area, pid_t parent);
void run_worker(struct area *area, struct task *task, pid_t parent);

int64_t clock_ns(int clock);
void write_entry(struct area *area, struct log *log, struct entry entry);
/* How long each call of a job works, and all of them together, in ns. */
const int64_t *job_times(const struct area *area, const struct task *task, int64_t job);
int64_t job_length(const struct area *area, const struct task *task, int64_t job);
/* Both return 0 or errno; a priority of SCHED_FIFO, a CPU from 1. */
int use_fifo(int priority);
int use_cpu(int cpu);

#endif
