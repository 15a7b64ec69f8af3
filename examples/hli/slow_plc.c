/* SPDX-License-Identifier: MIT */
/* The PLC of ../slow_plc.py in another process, through the HLI in shared memory (POSIX).

   cc -std=c11 -O2 -o slow_plc slow_plc.c
   nctakt run examples/crossing.nc --hli cell_7    (in one shell)
   ./slow_plc cell_7                               (in another one)

   It acknowledges each function after 200 ms; until then the path runs at half speed. */

#define _POSIX_C_SOURCE 200809L
#include <fcntl.h>
#include <inttypes.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "nctakt_hli.h"

static void pause_ns(long nanoseconds)
{
    struct timespec pause = {0, nanoseconds};
    nanosleep(&pause, NULL);
}

/* Return the image as soon as it exists, NULL after ten seconds. */
static char *attach(const char *name)
{
    char path[256];
    snprintf(path, sizeof path, "/%s", name);
    for (int look = 0; look < 1000; look++, pause_ns(10000000)) {
        int file = shm_open(path, O_RDWR, 0);
        struct stat status;
        if (file < 0)
            continue;
        char *image = MAP_FAILED;
        if (fstat(file, &status) == 0 && status.st_size >= (off_t)sizeof(hli_header))
            image = mmap(NULL, (size_t)status.st_size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        close(file);
        if (image == MAP_FAILED)
            continue;
        volatile hli_header *header = (hli_header *)image;
        if (header->ready && (uint64_t)status.st_size >= header->size)
            return image;
        munmap(image, (size_t)status.st_size);
    }
    return NULL;
}

/* Print new functions of a section, acknowledge those older than 200 ms; whether any wait. */
static bool answer(const hli_unit *units, uint32_t *acknowledged, uint32_t *seen, uint64_t now_us,
                   double x)
{
    bool waits = false;
    for (int slot = 0; slot < HLI_UNITS; slot++) {
        const hli_unit *unit = &units[slot];
        if (unit->serial == 0)
            continue;
        waits = true;
        if (unit->serial != seen[slot]) {
            seen[slot] = unit->serial;
            printf("%" PRIu64 " us %c%" PRIu32 " X %.3f\n", unit->time_us,
                   unit->letter == 1 ? 'M' : 'H', unit->number, x);
        }
        if (now_us - unit->time_us >= 200000)
            acknowledged[slot] = unit->serial;
    }
    return waits;
}

int main(int count, char **words)
{
    char *image = count == 2 ? attach(words[1]) : NULL;
    if (image == NULL) {
        fprintf(stderr, "usage: slow_plc NAME; NAME is that of nctakt run --hli\n");
        return 2;
    }
    volatile hli_header *header = (hli_header *)image;
    if (memcmp(image, HLI_MAGIC, sizeof HLI_MAGIC) != 0 || header->version != HLI_VERSION) {
        fprintf(stderr, "another layout\n");
        return 1;
    }
    volatile hli_link *link = (hli_link *)(image + header->link_offset);
    hli_channel *channel = (hli_channel *)(image + header->channel_offset);
    hli_command *command = (hli_command *)(image + header->command_offset);
    hli_axis *x = (hli_axis *)(image + header->axis_offset);
    uint32_t seen[2][HLI_UNITS] = {{0}};

    link->process = (uint64_t)getpid(); /* so that the CNC notices its end at once */
    command->plc_present_w = 1;
    while (header->ready) {
        uint64_t turn = header->turn;
        if (turn == link->turn) {
            pause_ns(20000);
            continue;
        }
        atomic_thread_fence(memory_order_acquire);
        uint64_t now_us = (header->tick - 1) * header->cycle_time_us;
        double x_mm = x->active_position_acs_r / 10000.0; /* 0.1 µm */
        bool waits = answer(channel->program, command->ack_program, seen[0], now_us, x_mm);
        waits |= answer(channel->realtime, command->ack_realtime, seen[1], now_us, x_mm);
        command->override_command_w = waits ? 500 : 1000; /* 0.1 % */
        atomic_thread_fence(memory_order_release);
        link->turn = turn;
    }
    return 0;
}
