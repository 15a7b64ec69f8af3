/* The HLI of nctakt: what CNC and PLC exchange. Made by nctakt; do not edit. */
#ifndef NCTAKT_HLI_H
#define NCTAKT_HLI_H

#include <stddef.h>
#include <stdint.h>

#define HLI_MAGIC "NCTAKT"
#define HLI_VERSION 9
#define HLI_UNITS 20

/* the start of the image: what it holds, where, and the clock */
typedef struct hli_header {
    char magic[8]; /* NCTAKT and two zero bytes */
    uint32_t version; /* 9; another one is another layout */
    uint32_t ready; /* 1 while the CNC is there; written last, taken away first */
    uint32_t size; /* the whole image (bytes) */
    uint32_t cycle_time_us; /* the length of a tick (µs) */
    uint32_t channels; /* number of hli_channel and of hli_command */
    uint32_t channel_offset; /* place of the first hli_channel (bytes) */
    uint32_t channel_size; /* from one hli_channel to the next (bytes) */
    uint32_t axes; /* number of hli_axis */
    uint32_t axis_offset; /* place of the first hli_axis (bytes) */
    uint32_t axis_size; /* from one hli_axis to the next (bytes) */
    uint32_t spindles; /* number of hli_spindle and of hli_spindle_command */
    uint32_t spindle_offset; /* place of the first hli_spindle (bytes) */
    uint32_t spindle_size; /* from one hli_spindle to the next (bytes) */
    uint32_t command_offset; /* place of the first hli_command (bytes) */
    uint32_t command_size; /* from one hli_command to the next (bytes) */
    uint32_t spindle_command_offset; /* of the first hli_spindle_command (bytes) */
    uint32_t spindle_command_size; /* from one of them to the next (bytes) */
    uint32_t link_offset; /* place of hli_link (bytes) */
    uint32_t ve_offset; /* place of the V.E variables (bytes) */
    uint32_t ve_size; /* of the V.E variables, all sections (bytes) */
    uint32_t names_offset; /* place of the names of the V.E variables (bytes) */
    uint32_t names_size; /* of these names, a text: docs/hli.md (bytes) */
    uint32_t lockstep; /* 1: the CNC waits for the PLC after each tick */
    uint64_t sequence; /* odd while the CNC writes; unchanged: what was read fits */
    uint64_t tick; /* ticks that have been run */
    uint64_t turn; /* in lockstep: counts the times that the CNC waits for the PLC */
    uint64_t process; /* ID of the CNC's process, whose end the PLC can notice */
} hli_header;
_Static_assert(offsetof(hli_header, magic) == 0, "magic");
_Static_assert(offsetof(hli_header, version) == 8, "version");
_Static_assert(offsetof(hli_header, ready) == 12, "ready");
_Static_assert(offsetof(hli_header, size) == 16, "size");
_Static_assert(offsetof(hli_header, cycle_time_us) == 20, "cycle_time_us");
_Static_assert(offsetof(hli_header, channels) == 24, "channels");
_Static_assert(offsetof(hli_header, channel_offset) == 28, "channel_offset");
_Static_assert(offsetof(hli_header, channel_size) == 32, "channel_size");
_Static_assert(offsetof(hli_header, axes) == 36, "axes");
_Static_assert(offsetof(hli_header, axis_offset) == 40, "axis_offset");
_Static_assert(offsetof(hli_header, axis_size) == 44, "axis_size");
_Static_assert(offsetof(hli_header, spindles) == 48, "spindles");
_Static_assert(offsetof(hli_header, spindle_offset) == 52, "spindle_offset");
_Static_assert(offsetof(hli_header, spindle_size) == 56, "spindle_size");
_Static_assert(offsetof(hli_header, command_offset) == 60, "command_offset");
_Static_assert(offsetof(hli_header, command_size) == 64, "command_size");
_Static_assert(offsetof(hli_header, spindle_command_offset) == 68, "spindle_command_offset");
_Static_assert(offsetof(hli_header, spindle_command_size) == 72, "spindle_command_size");
_Static_assert(offsetof(hli_header, link_offset) == 76, "link_offset");
_Static_assert(offsetof(hli_header, ve_offset) == 80, "ve_offset");
_Static_assert(offsetof(hli_header, ve_size) == 84, "ve_size");
_Static_assert(offsetof(hli_header, names_offset) == 88, "names_offset");
_Static_assert(offsetof(hli_header, names_size) == 92, "names_size");
_Static_assert(offsetof(hli_header, lockstep) == 96, "lockstep");
_Static_assert(offsetof(hli_header, sequence) == 104, "sequence");
_Static_assert(offsetof(hli_header, tick) == 112, "tick");
_Static_assert(offsetof(hli_header, turn) == 120, "turn");
_Static_assert(offsetof(hli_header, process) == 128, "process");
_Static_assert(sizeof(hli_header) == 136, "hli_header");

/* the PLC's side of the lockstep */
typedef struct hli_link {
    uint64_t turn; /* turn of the header, as soon as the PLC has answered */
    uint64_t process; /* ID of the PLC's process, whose end is noticed; 0: none */
} hli_link;
_Static_assert(offsetof(hli_link, turn) == 0, "turn");
_Static_assert(offsetof(hli_link, process) == 8, "process");
_Static_assert(sizeof(hli_link) == 16, "hli_link");

/* a slot for one M, H or T function */
typedef struct hli_unit {
    uint32_t serial; /* 0: free; else the running number of the function */
    uint32_t letter; /* 1 M, 2 H, 3 T */
    uint32_t number; /* of the function: 100 for M100, the tool of T */
    uint32_t sequence; /* its number among those of its tick and section, from 1 */
    uint32_t axis; /* logical of the axis or spindle that it is for, 0: channel */
    int32_t value; /* its value in the program, as in M110=130; 0 for none */
    uint32_t identifier; /* 1: the program's, 2 POS_RT: of a realtime cycle */
    uint32_t synchronisation; /* bits of its type, 1 MOS, 2 MVS_SVS … (P-CHAN-00041, P-CHAN-00027); POS_RT: always MOS */
    uint64_t time_us; /* the begin of the tick that has commanded it (µs) */
    uint64_t duration_us; /* the time that the channel list gives it (µs) */
} hli_unit;
_Static_assert(offsetof(hli_unit, serial) == 0, "serial");
_Static_assert(offsetof(hli_unit, letter) == 4, "letter");
_Static_assert(offsetof(hli_unit, number) == 8, "number");
_Static_assert(offsetof(hli_unit, sequence) == 12, "sequence");
_Static_assert(offsetof(hli_unit, axis) == 16, "axis");
_Static_assert(offsetof(hli_unit, value) == 20, "value");
_Static_assert(offsetof(hli_unit, identifier) == 24, "identifier");
_Static_assert(offsetof(hli_unit, synchronisation) == 28, "synchronisation");
_Static_assert(offsetof(hli_unit, time_us) == 32, "time_us");
_Static_assert(offsetof(hli_unit, duration_us) == 40, "duration_us");
_Static_assert(sizeof(hli_unit) == 48, "hli_unit");

/* the state of a channel */
typedef struct hli_channel {
    uint8_t state; /* 0 ready, 1 a program runs, 2 error, 3 reset */
    uint8_t wait_continue_r; /* 1: single block, M00 or M01 waits for START */
    uint8_t armed; /* 1: a selected program waits for START */
    uint32_t error; /* number of the error that has stopped the channel, else 0 */
    uint16_t retrace_r; /* 0: at its front, 1 backward over the history, 2 forward again */
    uint32_t history; /* blocks in the history of the path, the current one included */
    uint8_t inside_rt_loop_r; /* 1: the path is in a realtime loop */
    uint32_t history_size; /* blocks that the history holds (P-STUP-00033); 0: none */
    double tool_time; /* that the tool has worked since it came (s) */
    double tool_distance; /* that the tool has worked since it came (mm) */
    uint32_t life_serial; /* tool lives that were sent; another one: the values below */
    uint32_t life_tool; /* the number of the tool whose life was sent last */
    double life_time; /* its time (s) */
    double life_distance; /* its distance (mm) */
    uint32_t error_serial; /* how many errors have stopped the channel */
    uint32_t override_total; /* that acts (%) */
    int32_t active_feed_r; /* the speed on the path (µm/s) */
    int32_t dist_to_go_r; /* left of the block (0.1 µm) */
    uint32_t block_number_r; /* N number of the current block */
    uint32_t active_cycles; /* realtime cycles that run */
    hli_unit program[HLI_UNITS];
    hli_unit realtime[HLI_UNITS];
} hli_channel;
_Static_assert(offsetof(hli_channel, state) == 0, "state");
_Static_assert(offsetof(hli_channel, wait_continue_r) == 1, "wait_continue_r");
_Static_assert(offsetof(hli_channel, armed) == 2, "armed");
_Static_assert(offsetof(hli_channel, error) == 4, "error");
_Static_assert(offsetof(hli_channel, retrace_r) == 8, "retrace_r");
_Static_assert(offsetof(hli_channel, history) == 12, "history");
_Static_assert(offsetof(hli_channel, inside_rt_loop_r) == 16, "inside_rt_loop_r");
_Static_assert(offsetof(hli_channel, history_size) == 20, "history_size");
_Static_assert(offsetof(hli_channel, tool_time) == 24, "tool_time");
_Static_assert(offsetof(hli_channel, tool_distance) == 32, "tool_distance");
_Static_assert(offsetof(hli_channel, life_serial) == 40, "life_serial");
_Static_assert(offsetof(hli_channel, life_tool) == 44, "life_tool");
_Static_assert(offsetof(hli_channel, life_time) == 48, "life_time");
_Static_assert(offsetof(hli_channel, life_distance) == 56, "life_distance");
_Static_assert(offsetof(hli_channel, error_serial) == 64, "error_serial");
_Static_assert(offsetof(hli_channel, override_total) == 68, "override_total");
_Static_assert(offsetof(hli_channel, active_feed_r) == 72, "active_feed_r");
_Static_assert(offsetof(hli_channel, dist_to_go_r) == 76, "dist_to_go_r");
_Static_assert(offsetof(hli_channel, block_number_r) == 80, "block_number_r");
_Static_assert(offsetof(hli_channel, active_cycles) == 84, "active_cycles");
_Static_assert(offsetof(hli_channel, program) == 88, "program");
_Static_assert(offsetof(hli_channel, realtime) == 1048, "realtime");
_Static_assert(sizeof(hli_channel) == 2008, "hli_channel");

/* the state of an axis */
typedef struct hli_axis {
    char name[16]; /* its name in the channel, with a zero byte */
    uint16_t log_ax_n_r; /* its logical number */
    int32_t active_position_acs_r; /* command position, ACS (0.1 µm, 0.0001°) */
    int32_t current_position_acs_r; /* actual position, ACS (0.1 µm, 0.0001°) */
    int32_t end_position_acs_r; /* end of the motion, ACS (0.1 µm, 0.0001°) */
    double machine; /* command position, MCS (mm, °) */
    int32_t act_position_r; /* command position, PCS (0.1 µm, 0.0001°) */
    double distance_to_go; /* left to the target (mm, °) */
    uint32_t override_total; /* of its own motions (%) */
    uint8_t state; /* PLCopen: 1 Standstill, 2 DiscreteMotion, 3 ContinuousMotion, 4 Stopping, 5 ErrorStop, 6 SynchronizedMotion */
    uint8_t fill_up[3];
} hli_axis;
_Static_assert(offsetof(hli_axis, name) == 0, "name");
_Static_assert(offsetof(hli_axis, log_ax_n_r) == 16, "log_ax_n_r");
_Static_assert(offsetof(hli_axis, active_position_acs_r) == 20, "active_position_acs_r");
_Static_assert(offsetof(hli_axis, current_position_acs_r) == 24, "current_position_acs_r");
_Static_assert(offsetof(hli_axis, end_position_acs_r) == 28, "end_position_acs_r");
_Static_assert(offsetof(hli_axis, machine) == 32, "machine");
_Static_assert(offsetof(hli_axis, act_position_r) == 40, "act_position_r");
_Static_assert(offsetof(hli_axis, distance_to_go) == 48, "distance_to_go");
_Static_assert(offsetof(hli_axis, override_total) == 56, "override_total");
_Static_assert(offsetof(hli_axis, state) == 60, "state");
_Static_assert(sizeof(hli_axis) == 64, "hli_axis");

/* the state of a spindle; where the PLC turns it, the job that waits for it */
typedef struct hli_spindle {
    char name[16]; /* its name in programs, with a zero byte */
    uint32_t logical; /* its logical number */
    uint32_t channel; /* number of its channel, from 1 */
    uint32_t plc_controlled; /* 1: the PLC turns it (P-CHAN-00069) */
    int32_t active_rev_r; /* negative under M4; the CNC's only (µm/s, 0.001°/s) */
    double position; /* 0 … 360; of the CNC's only (°) */
    uint32_t job; /* 0: none waits; else the running number of the job */
    uint32_t function; /* 3, 4, 5 or 19: M3, M4, M5, M19 */
    uint32_t direction; /* of M19: 0 the shorter way, 1 forward, 2 back */
    uint64_t job_time_us; /* the begin of the tick that has commanded it (µs) */
    uint64_t job_duration_us; /* the time that the channel list gives it (µs) */
    double job_speed; /* the speed that is commanded (rev/min) */
    double job_position; /* of M19 (°) */
} hli_spindle;
_Static_assert(offsetof(hli_spindle, name) == 0, "name");
_Static_assert(offsetof(hli_spindle, logical) == 16, "logical");
_Static_assert(offsetof(hli_spindle, channel) == 20, "channel");
_Static_assert(offsetof(hli_spindle, plc_controlled) == 24, "plc_controlled");
_Static_assert(offsetof(hli_spindle, active_rev_r) == 28, "active_rev_r");
_Static_assert(offsetof(hli_spindle, position) == 32, "position");
_Static_assert(offsetof(hli_spindle, job) == 40, "job");
_Static_assert(offsetof(hli_spindle, function) == 44, "function");
_Static_assert(offsetof(hli_spindle, direction) == 48, "direction");
_Static_assert(offsetof(hli_spindle, job_time_us) == 56, "job_time_us");
_Static_assert(offsetof(hli_spindle, job_duration_us) == 64, "job_duration_us");
_Static_assert(offsetof(hli_spindle, job_speed) == 72, "job_speed");
_Static_assert(offsetof(hli_spindle, job_position) == 80, "job_position");
_Static_assert(sizeof(hli_spindle) == 88, "hli_spindle");

/* what the PLC commands a channel */
typedef struct hli_command {
    uint16_t override_command_w; /* the operator's override of the path (0.1 %) */
    uint8_t feedhold_command_w; /* 1: the path brakes to a standstill and stays there */
    uint8_t single_block_command_w; /* 1: the channel stops before each block */
    uint8_t continue_on_command_w; /* START: the PLC writes 1, the CNC takes it and writes 0 */
    uint8_t reset_command_w; /* RESET: the PLC writes 1, the CNC takes it and writes 0 */
    uint8_t plc_present_w; /* 1: the PLC acknowledges functions, 0: the CNC itself */
    uint8_t backward_motion_command_w; /* 1: the path is walked back, 0: forward again */
    uint8_t probe_command_w; /* 1: the probe touches (G100), or is on the edge (G108) */
    uint8_t m01_stop_enable_command_w; /* 1: M01 stops as M00 does */
    uint8_t mc_watchdog_enable_w; /* 1: the PLC shows in time that it lives, or it is an error */
    uint8_t mc_watchdog_alive_rw; /* the sign of life: the PLC writes 1, the CNC takes it, writes 0 */
    uint16_t block_search_type_command_w; /* block search of each program that begins: 0 none, 4 to a block */
    uint32_t block_search_number_command_w; /* N number of the block to which block search goes */
    uint32_t block_search_pass_command_w; /* the pass over this block at which the program begins, from 1 */
    uint32_t ack_program[20]; /* acknowledges program[i] of the channel: its serial */
    uint32_t ack_realtime[20]; /* acknowledges realtime[i] of the channel: its serial */
} hli_command;
_Static_assert(offsetof(hli_command, override_command_w) == 0, "override_command_w");
_Static_assert(offsetof(hli_command, feedhold_command_w) == 2, "feedhold_command_w");
_Static_assert(offsetof(hli_command, single_block_command_w) == 3, "single_block_command_w");
_Static_assert(offsetof(hli_command, continue_on_command_w) == 4, "continue_on_command_w");
_Static_assert(offsetof(hli_command, reset_command_w) == 5, "reset_command_w");
_Static_assert(offsetof(hli_command, plc_present_w) == 6, "plc_present_w");
_Static_assert(offsetof(hli_command, backward_motion_command_w) == 7, "backward_motion_command_w");
_Static_assert(offsetof(hli_command, probe_command_w) == 8, "probe_command_w");
_Static_assert(offsetof(hli_command, m01_stop_enable_command_w) == 9, "m01_stop_enable_command_w");
_Static_assert(offsetof(hli_command, mc_watchdog_enable_w) == 10, "mc_watchdog_enable_w");
_Static_assert(offsetof(hli_command, mc_watchdog_alive_rw) == 11, "mc_watchdog_alive_rw");
_Static_assert(offsetof(hli_command, block_search_type_command_w) == 12, "block_search_type_command_w");
_Static_assert(offsetof(hli_command, block_search_number_command_w) == 16, "block_search_number_command_w");
_Static_assert(offsetof(hli_command, block_search_pass_command_w) == 20, "block_search_pass_command_w");
_Static_assert(offsetof(hli_command, ack_program) == 24, "ack_program");
_Static_assert(offsetof(hli_command, ack_realtime) == 104, "ack_realtime");
_Static_assert(sizeof(hli_command) == 184, "hli_command");

/* what the PLC commands a spindle, and its answer for one that it turns */
typedef struct hli_spindle_command {
    uint32_t ack_job; /* acknowledges job of the spindle: its number */
    uint32_t reserved; /* not used */
    uint16_t override_command_w; /* the operator's override of a spindle that the CNC turns (0.1 %) */
    uint8_t fill_up[6];
} hli_spindle_command;
_Static_assert(offsetof(hli_spindle_command, ack_job) == 0, "ack_job");
_Static_assert(offsetof(hli_spindle_command, reserved) == 4, "reserved");
_Static_assert(offsetof(hli_spindle_command, override_command_w) == 8, "override_command_w");
_Static_assert(sizeof(hli_spindle_command) == 16, "hli_spindle_command");

#endif
