#include "exact/base/parallel.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "exact/base/fp_environment.h"
#include "exact/base/interrupt.h"
#include "exact/base/plain_locale.h"

namespace tribunal {

void begin_thread() {
  require_exact_rounding();
  use_plain_locale();
}

std::size_t run_blocks(std::size_t blocks, unsigned threads, const std::function<void(std::size_t, unsigned)>& work,
                       const std::function<bool()>& stop) {
  const OrderlyEnd orderly;
  std::atomic<std::size_t> next{0};
  std::atomic<bool> halt{false};
  std::exception_ptr error;
  std::mutex error_guard;
  const auto run = [&](unsigned worker) {
    try {
      if (worker == 0) {
        refuse_changed_rounding();
      } else {
        begin_thread();
      }
      while (!halt && interrupted() == 0 && !(stop && stop())) {
        const std::size_t block = next.fetch_add(1);
        if (block >= blocks) return;
        work(block, worker);
        refuse_changed_rounding();
      }
    } catch (...) {
      const std::scoped_lock lock(error_guard);
      if (!error) error = std::current_exception();
      halt = true;
    }
  };
  {
    std::vector<std::jthread> others;
    for (unsigned w = 1; w < threads; ++w) others.emplace_back(run, w);
    run(0);
  }
  if (error) std::rethrow_exception(error);
  const std::size_t taken = next.load();
  return taken < blocks ? taken : blocks;
}

}  // namespace tribunal
