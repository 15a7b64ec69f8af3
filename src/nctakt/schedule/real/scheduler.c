/* SPDX-License-Identifier: MIT */
/* The process that opens NC cycles: it waits until they are due, wakes the workers that are due,
 * and stops those that can be suspended so that other programs of the computer get their time.
 *
 * It is the workers' parent: if it dies, they die, and if Python's process dies, it ends the run
 * and removes all that was created for it.
 */
#define _GNU_SOURCE
#include "shared_area.h"

#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define SECOND 1000000000LL
/* How often a wait checks whether the run is to end. */
#define LOOK 100000000LL
/* The time from all workers being ready to the first NC interrupt. */
#define LEAD 20000000LL
#define PATIENCE (5 * SECOND)
#define SCHEDULER_PRIORITY 90

static volatile sig_atomic_t stop_requested, child_ended;

static void on_stop(int number)
{
    (void)number;
    stop_requested = 1;
}

static void on_child(int number)
{
    (void)number;
    child_ended = 1;
}

static struct task *task_at(struct area *area, int64_t i)
{
    return (struct task *)AT(area, area->tasks) + i;
}

static int64_t now_of(const struct area *area)
{
    return clock_ns(CLOCK_MONOTONIC) - area->origin;
}

static void log_entry(struct area *area, int kind, int64_t time, int64_t value, int64_t task,
                      int call)
{
    struct entry entry = {time, value, kind, (int32_t)task, call, 0};
    write_entry(area, &area->log, entry);
}

static int is_over(struct area *area)
{
    return stop_requested || child_ended || atomic_load(&area->is_full);
}

static void sleep_ns(int64_t length)
{
    struct timespec time = {length / SECOND, length % SECOND};
    nanosleep(&time, NULL);
}

/* Wait until a time; return whether it came before the end of the run. */
static int wait_until(struct area *area, int64_t moment)
{
    while (!is_over(area)) {
        int64_t now = now_of(area), wake = moment < now + LOOK ? moment : now + LOOK;
        if (now >= moment)
            return 1;
        wake += area->origin;
        struct timespec time = {wake / SECOND, wake % SECOND};
        clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, NULL);
    }
    return 0;
}

/* Wait for an interrupt from a semaphore; return whether it came before `moment`. */
static int wait_for_post(struct area *area, sem_t *source, int64_t moment)
{
    while (!is_over(area)) {
        int64_t now = now_of(area);
        int64_t wait = moment - now < LOOK ? moment - now : LOOK;
        if (sem_trywait(source) == 0)
            return 1;
        if (wait <= 0)
            return 0;
        int64_t until = clock_ns(CLOCK_REALTIME) + wait;
        struct timespec time = {until / SECOND, until % SECOND};
        if (sem_timedwait(source, &time) == 0)
            return 1;
    }
    return 0;
}

/* When suspendable tasks are stopped in the cycle that begins at `begin`; the same as in the
 * simulation (schedule/model.py, suspension_point). */
static int64_t suspension_point(const struct area *area, int64_t begin)
{
    int64_t before = area->cycle - area->windows, since = begin - area->phase;
    if (before <= 0)
        return begin;
    if (area->elapsed) {
        int64_t slices = (since + before + area->slice - 1) / area->slice;
        return area->phase + slices * area->slice;
    }
    return begin + area->slice - since % area->slice + before - area->slice;
}

static int can_stop(const struct area *area, const struct task *task)
{
    int64_t cpu = task->cpu == ANY_CPU ? atomic_load(&task->cpu_now) : task->cpu;
    return task->kind == ASYNCHRONOUS && atomic_load(&task->busy) > 0 &&
           (cpu == ANY_CPU || (area->windows_cpus >> (cpu - 1) & 1));
}

static void suspend(struct area *area)
{
    for (int64_t i = 0; i < area->task_count; i++) {
        struct task *task = task_at(area, i);
        if (!can_stop(area, task))
            continue;
        kill((pid_t)task->pid, SIGSTOP);
        /* It may have finished on another processor meanwhile. */
        if (atomic_load(&task->busy) == 0) {
            kill((pid_t)task->pid, SIGCONT);
            continue;
        }
        task->is_suspended = 1;
        log_entry(area, ENTRY_SUSPEND, now_of(area), atomic_load(&task->left), task->number, 0);
    }
}

/* Continue suspended tasks; in a cycle that belongs to Windows entirely they stay stopped. */
static void resume(struct area *area, int is_starved)
{
    for (int64_t i = 0; i < area->task_count; i++) {
        struct task *task = task_at(area, i);
        if (!task->is_suspended)
            continue;
        task->is_suspended = 0;
        log_entry(area, ENTRY_RESUME, now_of(area), atomic_load(&task->left), task->number, 0);
        if (!is_starved)
            kill((pid_t)task->pid, SIGCONT);
    }
}

/* Activate a task whose process is not ours: only its semaphore is visible. */
static void release_foreign(struct area *area, struct task *task)
{
    int waiting = 0;
    sem_getvalue(task->semaphore_address, &waiting);
    if (waiting > 0)
        log_entry(area, ENTRY_OVERFLOW, now_of(area), 0, task->number, 1);
    log_entry(area, ENTRY_RELEASE, now_of(area), task->jobs++, task->number, 0);
    task->wakes = 1;
}

static void release(struct area *area, struct task *task, int64_t begin)
{
    int64_t busy = atomic_load(&task->busy);
    if (busy > 0) {
        int keeps = task->kind == EXTERNAL || area->policy == QUEUE ||
                    (area->policy == PEND && busy == 1);
        int64_t left = atomic_load(&task->left);
        log_entry(area, ENTRY_OVERFLOW, now_of(area), left, task->number, keeps);
        if (!keeps)
            return;
    }
    if (task->jobs == task->max_jobs) {
        atomic_store(&area->is_full, 1);
        return;
    }
    if (busy == 0)
        atomic_store(&task->left, job_length(area, task, task->jobs));
    ((int64_t *)AT(area, task->due))[task->jobs] = begin;
    log_entry(area, ENTRY_RELEASE, now_of(area), task->jobs++, task->number, busy > 0);
    atomic_fetch_add(&task->busy, 1);
    task->wakes = 1;
}

/* Handle the NC interrupt of `number`. */
static void open_cycle(struct area *area, int64_t number, int64_t begin)
{
    int is_starved = area->windows > 0 && suspension_point(area, begin) <= begin;
    resume(area, is_starved);
    for (int64_t i = 0; i < area->task_count; i++) {
        struct task *task = task_at(area, i);
        if (number % task->every != 0 || (task->has_process && task->calls == 0))
            continue;
        if (task->has_process)
            release(area, task, begin);
        else
            release_foreign(area, task);
    }
    if (is_starved)
        suspend(area);
    for (int64_t i = 0; i < area->task_count; i++) {
        struct task *task = task_at(area, i);
        if (task->wakes)
            sem_post(task->semaphore_address);
        task->wakes = 0;
    }
}

static void run_timed(struct area *area)
{
    const int64_t *moments = AT(area, area->moments);
    for (int64_t number = 0; wait_until(area, moments[number]); number++) {
        int64_t begin = moments[number];
        log_entry(area, ENTRY_INTERRUPT, now_of(area), begin, 0, 0);
        if (number == area->cycles)
            return;
        open_cycle(area, number, begin);
        if (area->windows == 0)
            continue;
        int64_t point = suspension_point(area, begin);
        if (point <= begin || point > moments[number + 1])
            continue;
        if (!wait_until(area, point))
            return;
        log_entry(area, ENTRY_POINT, now_of(area), point, 0, 0);
        suspend(area);
    }
}

static void run_on_posts(struct area *area, sem_t *source)
{
    int64_t number = 0;
    /* Posts from before this wait are no NC interrupts. */
    while (sem_trywait(source) == 0)
        area->drained++;
    int is_posted = wait_for_post(area, source, area->limit);
    while (is_posted) {
        int64_t begin = now_of(area);
        log_entry(area, ENTRY_INTERRUPT, begin, begin, 0, 0);
        if (begin >= area->limit)
            return;
        open_cycle(area, number++, begin);
        int64_t point = suspension_point(area, begin);
        if (area->windows == 0 || point <= begin || point > area->limit) {
            is_posted = wait_for_post(area, source, area->limit);
            continue;
        }
        is_posted = wait_for_post(area, source, point);
        if (!is_posted && !is_over(area)) {
            log_entry(area, ENTRY_POINT, now_of(area), point, 0, 0);
            suspend(area);
            is_posted = wait_for_post(area, source, area->limit);
        }
    }
}

/* Start all workers and wait until they are ready; return whether they are. */
static int start_workers(struct area *area)
{
    int64_t wanted = 0;
    pid_t own = getpid();
    for (int64_t i = 0; i < area->task_count; i++) {
        struct task *task = task_at(area, i);
        task->semaphore_address = &task->wake;
        if (task->kind == EXTERNAL) {
            task->semaphore_address = sem_open(task->semaphore, 0);
            if (task->semaphore_address == SEM_FAILED) {
                area->status = NO_SEMAPHORE;
                area->status_task = task->number;
                area->status_number = errno;
                return 0;
            }
        } else if (sem_init(&task->wake, 1, 0) != 0) {
            abort();
        }
        if (!task->has_process)
            continue;
        pid_t pid = fork();
        if (pid == 0) {
            run_worker(area, task, own);
            _exit(0);
        }
        task->pid = pid;
        if (pid < 0) {
            area->status = NO_PROCESS;
            area->status_task = task->number;
            area->status_number = errno;
            return 0;
        }
        wanted++;
    }
    int64_t end = clock_ns(CLOCK_MONOTONIC) + PATIENCE;
    while (atomic_load(&area->ready) < wanted && !is_over(area)) {
        if (clock_ns(CLOCK_MONOTONIC) > end) {
            area->status = NO_PROCESS;
            area->status_number = ETIMEDOUT;
            return 0;
        }
        sleep_ns(1000000);
    }
    return !is_over(area);
}

/* Find a worker that has ended without being asked to. */
static void find_ended(struct area *area)
{
    for (int64_t i = 0; i < area->task_count; i++) {
        struct task *task = task_at(area, i);
        int how = 0;
        if (task->pid <= 0 || waitpid((pid_t)task->pid, &how, WNOHANG) <= 0)
            continue;
        task->pid = 0;
        area->status = PROCESS_ENDED;
        area->status_task = task->number;
        area->status_number = WIFSIGNALED(how) ? WTERMSIG(how) : 0;
    }
}

static void end_workers(struct area *area)
{
    atomic_store(&area->stop, 1);
    for (int64_t i = 0; i < area->task_count; i++) {
        struct task *task = task_at(area, i);
        if (task->pid <= 0)
            continue;
        kill((pid_t)task->pid, SIGCONT);
        sem_post(task->semaphore_address);
    }
    int64_t end = clock_ns(CLOCK_MONOTONIC) + SECOND;
    for (int64_t i = 0; i < area->task_count; i++) {
        struct task *task = task_at(area, i);
        while (task->pid > 0 && waitpid((pid_t)task->pid, NULL, WNOHANG) == 0) {
            if (clock_ns(CLOCK_MONOTONIC) > end)
                kill((pid_t)task->pid, SIGKILL);
            sleep_ns(500000);
        }
    }
}

/* Remove all named objects of the system. */
static void clean(struct area *area)
{
    for (int64_t i = 0; i < area->task_count; i++) {
        struct task *task = task_at(area, i);
        if (task->kind != EXTERNAL)
            continue;
        int waiting = 0;
        if (task->semaphore_address != NULL && task->semaphore_address != SEM_FAILED)
            sem_getvalue(task->semaphore_address, &waiting);
        task->waiting_at_end = waiting;
        sem_unlink(task->semaphore);
    }
    unlink(area->record);
    area->is_clean = 1;
}

static void watch_signals(void)
{
    struct sigaction stop = {.sa_handler = on_stop};
    struct sigaction child = {.sa_handler = on_child, .sa_flags = SA_NOCLDSTOP};
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    sigaction(SIGTERM, &stop, NULL);
    sigaction(SIGINT, &stop, NULL);
    sigaction(SIGHUP, &stop, NULL);
    sigaction(SIGCHLD, &child, NULL);
}

void run_scheduler(struct area *area, pid_t parent)
{
    watch_signals();
    prctl(PR_SET_NAME, "nctakt-schedule");
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent)
        stop_requested = 1;
    if (area->wants_fifo)
        area->fifo_error = use_fifo(SCHEDULER_PRIORITY);
    sem_t *source = NULL;
    if (area->from_semaphore) {
        source = sem_open(area->source, 0);
        if (source == SEM_FAILED) {
            area->status = NO_SEMAPHORE;
            area->status_task = -1;
            area->status_number = errno;
        }
    }
    if (area->status == RUNNING && start_workers(area)) {
        area->origin = clock_ns(CLOCK_MONOTONIC) + LEAD;
        if (source != NULL)
            run_on_posts(area, source);
        else
            run_timed(area);
        area->end = now_of(area);
    }
    if (child_ended)
        find_ended(area);
    if (area->status == RUNNING && atomic_load(&area->is_full))
        area->status = LOG_FULL;
    if (area->status == RUNNING)
        area->status = stop_requested ? STOPPED : DONE;
    end_workers(area);
    clean(area);
}
