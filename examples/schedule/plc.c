/* SPDX-License-Identifier: MIT */
/* An external thread: a program of its own that a schedule wakes through a named semaphore.
 *
 *     cc -O2 -o plc examples/schedule/plc.c -pthread
 *     ./plc /plc &
 *     nctakt schedule run examples/schedule/rtconf.lis --load examples/schedule/load.toml
 *
 * plc NAME [PRIORITY]: waits up to ten seconds for the semaphore NAME, then works at each wake-up
 * until none comes for a second, and prints their number. With PRIORITY it uses SCHED_FIFO;
 * `nctakt schedule run --dry-run` prints the one that fits the list.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <semaphore.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static struct timespec in_seconds(int seconds)
{
    struct timespec time;
    clock_gettime(CLOCK_REALTIME, &time);
    time.tv_sec += seconds;
    return time;
}

/* The run creates the semaphore; this program may start before it. */
static sem_t *open_semaphore(const char *name)
{
    const struct timespec pause = {0, 10000000};
    for (int i = 0; i < 1000; i++) {
        sem_t *found = sem_open(name, 0);
        if (found != SEM_FAILED || errno != ENOENT)
            return found;
        nanosleep(&pause, NULL);
    }
    return SEM_FAILED;
}

/* The work of the PLC in one cycle. */
static void work(unsigned long *sum)
{
    for (unsigned long i = 0; i < 10000; i++)
        *sum = *sum * 31 + i;
}

int main(int count, char **words)
{
    if (count < 2) {
        fprintf(stderr, "usage: %s NAME [PRIORITY]\n", words[0]);
        return 2;
    }
    if (count > 2) {
        struct sched_param parameter = {.sched_priority = atoi(words[2])};
        if (sched_setscheduler(0, SCHED_FIFO, &parameter) != 0)
            fprintf(stderr, "no SCHED_FIFO: %s\n", strerror(errno));
    }
    sem_t *semaphore = open_semaphore(words[1]);
    if (semaphore == SEM_FAILED) {
        fprintf(stderr, "%s: %s\n", words[1], strerror(errno));
        return 1;
    }
    unsigned long wake_ups = 0, sum = 0;
    for (;;) {
        struct timespec end = in_seconds(1);
        if (sem_timedwait(semaphore, &end) == 0) {
            work(&sum);
            wake_ups++;
        } else if (errno != EINTR) {
            break;
        }
    }
    printf("woken %lu times (%lx)\n", wake_ups, sum);
    sem_close(semaphore);
    return 0;
}
