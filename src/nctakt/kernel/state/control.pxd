# SPDX-License-Identifier: MIT
# C types of control.py.
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.base.timers cimport Timers
from nctakt.kernel.cycles.actions cimport FeedMemory
from nctakt.kernel.cycles.branches cimport IfAlways, IfEdge, IfOnce, Reaction
from nctakt.kernel.cycles.conditions cimport Condition
from nctakt.kernel.cycles.context cimport Context
from nctakt.kernel.cycles.cycles cimport CycleManager, RealtimeCycle
from nctakt.kernel.cycles.instructions cimport Counted
from nctakt.kernel.kernel cimport Kernel
from nctakt.kernel.plc.axis_requests cimport AxisRequests
from nctakt.kernel.plc.panel cimport Panel
from nctakt.kernel.plc.technology_slots cimport Hli, Section
from nctakt.kernel.tick.axis_exchange cimport AxisExchange
from nctakt.kernel.tick.block_scope cimport BlockScope
from nctakt.kernel.tick.channel cimport Channel
from nctakt.kernel.tick.channel_signals cimport ChannelSignals
from nctakt.kernel.tick.command_execution cimport CommandExecutor
from nctakt.kernel.tick.command_queue cimport CommandQueue
from nctakt.kernel.tick.loop_body cimport LoopBody
from nctakt.kernel.tick.signals cimport SignalBoard
from nctakt.kernel.tick.tool_lives cimport ToolLives

cpdef copy_record(Record source, Record target)
cpdef tuple arrays_of_record(Record part)
cpdef tuple arrays_of_timers(Timers part)
cpdef copy_feed_memory(FeedMemory source, FeedMemory target)
cpdef copy_reaction(Reaction source, Reaction target)
cpdef copy_if_once(IfOnce source, IfOnce target)
cpdef copy_if_edge(IfEdge source, IfEdge target)
cpdef copy_if_always(IfAlways source, IfAlways target)
cpdef copy_condition(Condition source, Condition target)
cpdef copy_context(Context source, Context target)
cpdef tuple arrays_of_context(Context part)
cpdef copy_realtime_cycle(RealtimeCycle source, RealtimeCycle target)
cpdef copy_cycle_manager(CycleManager source, CycleManager target)
cpdef tuple arrays_of_cycle_manager(CycleManager part)
cpdef copy_counted(Counted source, Counted target)
cpdef copy_kernel(Kernel source, Kernel target)
cpdef tuple arrays_of_kernel(Kernel part)
cpdef copy_axis_requests(AxisRequests source, AxisRequests target)
cpdef tuple arrays_of_axis_requests(AxisRequests part)
cpdef copy_panel(Panel source, Panel target)
cpdef tuple arrays_of_panel(Panel part)
cpdef copy_section(Section source, Section target)
cpdef tuple arrays_of_section(Section part)
cpdef copy_hli(Hli source, Hli target)
cpdef copy_block_scope(BlockScope source, BlockScope target)
cpdef copy_channel(Channel source, Channel target)
cpdef tuple arrays_of_channel(Channel part)
cpdef copy_tool_lives(ToolLives source, ToolLives target)
cpdef copy_command_executor(CommandExecutor source, CommandExecutor target)
cpdef tuple arrays_of_command_executor(CommandExecutor part)
cpdef copy_command_queue(CommandQueue source, CommandQueue target)
cpdef tuple arrays_of_command_queue(CommandQueue part)
cpdef copy_loop_body(LoopBody source, LoopBody target)
cpdef tuple arrays_of_loop_body(LoopBody part)
cpdef copy_signal_board(SignalBoard source, SignalBoard target)
cpdef tuple arrays_of_signal_board(SignalBoard part)
cpdef copy_channel_signals(ChannelSignals source, ChannelSignals target)
cpdef copy_axis_exchange(AxisExchange source, AxisExchange target)
cpdef tuple arrays_of_axis_exchange(AxisExchange part)
