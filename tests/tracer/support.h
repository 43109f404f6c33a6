// What the tracer's tests share.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "exact/base/failure.h"
#include "exact/methods/methods.h"

namespace tribunal::testing {

/// splitmix64: the same numbers everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return next() % n; }
  int within(int lo, int hi) { return lo + static_cast<int>(below(static_cast<std::size_t>(hi - lo + 1))); }
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  Point3 point(double size) {
    const double x = size * (2 * unit() - 1);
    const double y = size * (2 * unit() - 1);
    const double z = size * (2 * unit() - 1);
    return {x, y, z};
  }

 private:
  std::uint64_t state_;
};

inline const Method& method(const char* name) {
  const Method* m = find_method(name);
  if (!m) throw std::runtime_error(std::string("no method ") + name);
  return *m;
}

/// A directory that goes away with the test.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = std::filesystem::temp_directory_path() / "tribunal-XXXXXX";
    path_ = mkdtemp(name.data());
  }
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }

  std::string file(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }
  std::string path(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// The message of the Failure with Exit::bad_input that `run` throws; if it throws none, the test fails.
template <class Run>
std::string refusal_of(const Run& run) {
  try {
    run();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::bad_input) << failure.what();
    EXPECT_EQ(std::string(failure.what()).find('\n'), std::string::npos) << "more than one line";
    return failure.what();
  }
  ADD_FAILURE() << "was accepted";
  return {};
}

}  // namespace tribunal::testing
