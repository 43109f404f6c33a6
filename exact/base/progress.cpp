#include "exact/base/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace tribunal {

Progress::Progress(std::string label, std::string unit, std::uint64_t total)
    : label_(std::move(label)), unit_(std::move(unit)), total_(total), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (terminal_) std::fputs("\r\x1b[K", stderr);
}

double Progress::elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

void Progress::add(std::uint64_t done, std::uint64_t findings) {
  done_ += done;
  findings_ += findings;
  if (!terminal_) return;
  const std::unique_lock lock(drawing_, std::try_to_lock);
  if (!lock.owns_lock() || Clock::now() - drawn_ < std::chrono::milliseconds(200)) return;
  drawn_ = Clock::now();
  draw();
}

void Progress::draw() {
  const double done = static_cast<double>(done_.load());
  const double rate = done / std::max(elapsed(), 1e-9);
  std::string line = label_ + "  ";
  if (total_ > 0) line += std::to_string(static_cast<int>(100 * done / static_cast<double>(total_))) + " %  ";
  line += compact(done) + " " + unit_ + "  " + compact(rate) + "/s";
  if (total_ > 0 && rate > 0) {
    line += "  " + std::to_string(std::lround((static_cast<double>(total_) - done) / rate)) + " s left";
  }
  if (findings_ > 0) line += "  " + compact(static_cast<double>(findings_.load())) + " wrong";
  std::fprintf(stderr, "\r\x1b[K%s", line.c_str());
}

std::string compact(double x) {
  constexpr std::pair<double, const char*> units[] = {{1e9, " G"}, {1e6, " M"}, {1e3, " k"}};
  char text[32];
  for (const auto& [size, name] : units) {
    if (x < size) continue;
    std::snprintf(text, sizeof text, "%.3g%s", x / size, name);
    return text;
  }
  std::snprintf(text, sizeof text, "%.0f", x);
  return text;
}

}  // namespace tribunal
