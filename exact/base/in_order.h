// A sequence worked on by several threads, with results taken in the order of the sequence.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <mutex>
#include <string>
#include <vector>

#include "exact/base/interrupt.h"
#include "exact/base/parallel.h"

namespace tribunal {

/// Reads one item after the other, works on them on `threads` workers, and takes the results one after the other in the
/// order of reading: what `take` sees does not depend on the threads. There are no more items and results at a time
/// than workers. `read` and `take` never run twice at a time. The first failure in the order of the items, whether in
/// reading, working or taking, is thrown here once all before it was taken, and nothing after it is. Fails with 128 +
/// the signal, saying what is missing now, if a signal asked for an end.
///
/// read(Item&) → whether there was one more; work(const Item&, Result&); take(Result&). Items and results are used
/// again by their workers, which spares the memory's clearing: `read` overwrites what was there, and results are
/// emptied by clear(), if they have that, else made anew.
template <class Item, class Result, class Read, class Work, class Take>
void run_in_order(unsigned threads, const std::string& missing, const Read& read, const Work& work, const Take& take) {
  std::mutex reading, taking;
  std::condition_variable turn_came;
  std::uint64_t turns = 0, taken = 0;  // by `reading`, by `taking`
  std::atomic<bool> ended{false};
  bool failed = false;  // by `taking`

  std::vector<Item> items(threads);
  std::vector<Result> results(threads);

  const auto one_item = [&](std::size_t, unsigned worker) {
    Item& item = items[worker];
    Result& result = results[worker];
    if constexpr (requires { result.clear(); }) {
      result.clear();
    } else {
      result = Result();
    }
    std::exception_ptr failure;
    std::uint64_t turn = 0;
    {
      const std::scoped_lock lock(reading);
      if (ended) return;
      try {
        ended = !read(item);
        if (ended) return;
      } catch (...) {
        failure = std::current_exception();
        ended = true;
      }
      turn = turns++;
    }
    try {
      if (!failure) work(item, result);
    } catch (...) {
      failure = std::current_exception();
    }
    std::unique_lock lock(taking);
    turn_came.wait(lock, [&] { return taken == turn || failed; });
    if (failed) return;
    try {
      if (failure) std::rethrow_exception(failure);
      take(result);
    } catch (...) {
      failed = true;
      ended = true;
      turn_came.notify_all();
      throw;
    }
    ++taken;
    turn_came.notify_all();
  };
  run_blocks(std::numeric_limits<std::size_t>::max(), threads, one_item, [&] { return ended.load(); });
  fail_if_interrupted(missing);
}

}  // namespace tribunal
