#include "exact/base/spool.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "exact/base/failure.h"
#include "exact/base/shown.h"

namespace tribunal {
namespace {

constexpr std::size_t piece_size = std::size_t{1} << 18;

std::string directory() {
  const char* const given = std::getenv("TMPDIR");
  return given != nullptr && *given != '\0' ? given : "/tmp";
}

Failure failed(const char* what) {
  return Failure(Exit::output_failed, "a temporary file in " + directory() + ": cannot " + what + ": " +
                                          std::strerror(errno) + "; TMPDIR names another directory");
}

int open_without_name() {
  std::string path = directory() + "/tribunal-XXXXXX";
  const int file = mkstemp(path.data());
  if (file < 0) throw failed("make it");
  unlink(path.c_str());
  return file;
}

}  // namespace

Spool::~Spool() {
  if (file_ >= 0) close(file_);
}

Spool::Spool(Spool&& other) noexcept
    : memory_(other.memory_),
      held_(std::exchange(other.held_, {})),
      spilled_(std::exchange(other.spilled_, 0)),
      file_(std::exchange(other.file_, -1)) {}

Spool& Spool::operator=(Spool&& other) noexcept {
  std::swap(memory_, other.memory_);
  std::swap(held_, other.held_);
  std::swap(spilled_, other.spilled_);
  std::swap(file_, other.file_);
  return *this;
}

void Spool::write(std::string_view text) {
  held_ += text;
  if (held_.size() > memory_) spill();
}

void Spool::spill() {
  if (file_ < 0) file_ = open_without_name();
  for (std::string_view rest = held_; !rest.empty();) {
    const ssize_t n = pwrite(file_, rest.data(), rest.size(), static_cast<off_t>(spilled_));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw failed("write");
    spilled_ += static_cast<std::uint64_t>(n);
    rest.remove_prefix(static_cast<std::size_t>(n));
  }
  held_.clear();
}

std::string Spool::at(std::uint64_t offset, std::size_t size) const {
  if (offset >= spilled_) {
    const std::uint64_t begin = offset - spilled_;
    return begin < held_.size() ? held_.substr(begin, size) : std::string();
  }
  std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(size, spilled_ - offset)), '\0');
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = pread(file_, text.data() + done, text.size() - done, static_cast<off_t>(offset + done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw failed("read");
    done += static_cast<std::size_t>(n);
  }
  if (text.size() < size) text += held_.substr(0, size - text.size());
  return text;
}

void Spool::for_each_piece(const std::function<void(std::string_view)>& visit) const {
  for (std::uint64_t offset = 0; offset < size();) {
    std::string piece = at(offset, piece_size);
    const std::size_t newline = piece.rfind('\n');
    if (offset + piece.size() < size()) {
      piece.resize(newline != std::string::npos ? newline + 1 : whole_characters(piece));
    }
    visit(piece);
    offset += piece.size();
  }
}

}  // namespace tribunal
