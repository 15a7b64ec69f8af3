/* SPDX-License-Identifier: MIT */
/* The memory that Python, the scheduler and the workers share; area.py has the same layout.
 *
 * Times are ns since `origin`, a time of CLOCK_MONOTONIC; offsets are bytes from the
 * start of the area. Each log has one writer. Fields used by several processes are atomic.
 */
#ifndef NCTAKT_SHARED_AREA_H
#define NCTAKT_SHARED_AREA_H

#include <semaphore.h>
#include <stdatomic.h>
#include <stdint.h>
#include <sys/types.h>

#define NAME_SIZE 256
#define ANY_CPU 0

enum task_kind { REALTIME, ASYNCHRONOUS, EXTERNAL };
enum overflow_policy { SKIP, PEND, QUEUE };

/* Kinds of log entries, each with time, value, call, cpu; the comment says what the value is. */
enum entry_kind {
    ENTRY_INTERRUPT, /* when the interrupt was due; time: when it was handled */
    ENTRY_POINT,     /* the same for the suspension point */
    ENTRY_RELEASE,   /* the job's number; call 1: it waits for another job */
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
    int64_t entries, capacity; /* offset of the first entry, maximum number */
    _Atomic int64_t count;
};

struct task {
    char name[16];
    char semaphore[NAME_SIZE];  /* of an external thread, with a leading slash */
    int64_t number;             /* its place in the model */
    int64_t kind;
    int64_t has_process;        /* 0: a process outside the run waits on the semaphore */
    int64_t every;
    int64_t cpu;                /* from 1 */
    int64_t priority;           /* of SCHED_FIFO */
    int64_t calls, rows, times; /* rows of execution times, one for each call */
    int64_t due, max_jobs;     /* when each job was due */
    struct log log;
    /* Written during the run. */
    int64_t pid, jobs, is_suspended, wakes;
    int64_t cpu_error, waiting_at_end;
    _Atomic int64_t busy;       /* unfinished jobs */
    _Atomic int64_t left, cpu_now;
    union {
        sem_t wake;
        int64_t room[8];
    };
    sem_t *semaphore_address;
};

struct area {
    int64_t task_count, tasks;  /* the most urgent task first */
    int64_t cycles, moments;    /* when each NC interrupt comes, including the final one */
    int64_t limit;              /* how long interrupts from a semaphore are awaited */
    int64_t cycle, slice, windows, elapsed, phase;
    int64_t windows_cpus;       /* bit c-1 for CPU c */
    int64_t policy;
    int64_t wants_fifo;
    int64_t from_semaphore;
    char source[NAME_SIZE];     /* the semaphore that gives NC interrupts */
    char record[NAME_SIZE];     /* the file that lists the names to remove */
    struct log log;
    /* Written during the run. */
    int64_t origin, fifo_error, status, status_task, status_number, is_clean;
    int64_t drained;            /* posts of the source before the start */
    int64_t end;                /* when the last cycle ended */
    _Atomic int64_t ready, stop, is_full;
};

#define AT(area, offset) ((void *)((char *)(area) + (offset)))

void run_scheduler(struct area *area, pid_t parent);
void run_worker(struct area *area, struct task *task, pid_t parent);

int64_t clock_ns(int clock);
void write_entry(struct area *area, struct log *log, struct entry entry);
/* The execution time of each call of a job, and their sum, in ns. */
const int64_t *job_times(const struct area *area, const struct task *task, int64_t job);
int64_t job_length(const struct area *area, const struct task *task, int64_t job);
/* Both return 0 or errno; `priority` of SCHED_FIFO, `cpu` from 1. */
int use_fifo(int priority);
int use_cpu(int cpu);

#endif
