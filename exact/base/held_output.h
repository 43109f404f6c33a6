// Output of any length that appears whole or not at all, on standard output too.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace tribunal {

/// A file, or standard output for "-", written piece by piece in bounded memory. Nothing of it appears before commit(),
/// and without that nothing ever: a file that can be renamed waits under a temporary name, and what cannot, such as a
/// pipe, in a spool.
class HeldOutput {
 public:
  explicit HeldOutput(const std::string& path);
  ~HeldOutput();
  HeldOutput(const HeldOutput&) = delete;
  HeldOutput& operator=(const HeldOutput&) = delete;

  void write(std::string_view text);
  void commit();

 private:
  class Way;
  std::unique_ptr<Way> way_;
};

}  // namespace tribunal
