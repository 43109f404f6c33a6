// Blocks of work over threads. The order of blocks never shows in a result: workers fill slots, the caller merges.
#pragma once

#include <cstddef>
#include <functional>

namespace tribunal {

/// What a thread of ours begins with: checks and repairs its floating-point environment, takes the plain locale.
void begin_thread();

/// Runs `work(block, worker)` for every block in [0, blocks) on `threads` workers, each with the plain
/// locale and a floating-point environment that is checked when it begins and after every block. An exception in a
/// worker stops the others and is rethrown here. Returns the number of blocks done: fewer than `blocks` only if a
/// signal asked for an end or `stop` (may be empty) said so; those done are then a prefix.
std::size_t run_blocks(std::size_t blocks, unsigned threads, const std::function<void(std::size_t, unsigned)>& work,
                       const std::function<bool()>& stop = {});

}  // namespace tribunal
