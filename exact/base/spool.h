// Text of any length between its making and its writing, in bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace tribunal {

/// Text that grows at its end and can be read from its start: in memory while it is short, then in a file without a
/// name in the directory TMPDIR (if unset, /tmp), which the system removes with the process, however that ends. Fails
/// with Exit::output_failed where that file cannot be made, written or read.
class Spool {
 public:
  static constexpr std::size_t usual_memory = std::size_t{1} << 20;

  /// `memory`: how many bytes may be held.
  explicit Spool(std::size_t memory = usual_memory) : memory_(memory) {}
  ~Spool();
  Spool(Spool&& other) noexcept;
  Spool& operator=(Spool&& other) noexcept;

  void write(std::string_view text);

  std::uint64_t size() const { return spilled_ + held_.size(); }

  /// Up to `size` bytes from `offset` on, fewer only where the text ends; with what was written before this call.
  /// Several threads may read, while none writes.
  std::string at(std::uint64_t offset, std::size_t size) const;

  /// Calls `visit` with all of the text, piece by piece. A piece ends with a line, but where a line has no end within
  /// 256 KiB: then with a character of UTF-8.
  void for_each_piece(const std::function<void(std::string_view)>& visit) const;

 private:
  void spill();

  std::size_t memory_;
  std::string held_{};         ///< the text's end
  std::uint64_t spilled_ = 0;  ///< bytes before it, in the file
  int file_ = -1;
};

}  // namespace tribunal
