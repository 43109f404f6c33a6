#include "exact/base/lines.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "exact/base/failure.h"

namespace tribunal {
namespace {

constexpr std::size_t read_size = std::size_t{1} << 18;

/// A shared pointer calls it for no file too.
struct Closer {
  void operator()(std::FILE* file) const {
    if (file != nullptr && file != stdin) std::fclose(file);
  }
};

Failure cannot_read(const std::string& path) {
  return bad_input(path, 0, std::string("cannot read: ") + std::strerror(errno));
}

}  // namespace

void LineBlock::fail_too_long(const std::string& path, std::size_t number) {
  throw bad_input(path, number, "line longer than 1 MiB, expected one JSON object");
}

/// Appends to the buffer, after dropping what was given out. False at the end of the text.
bool LineReader::fill() {
  if (at_end_) return false;
  buffer_.erase(0, begin_);
  begin_ = 0;
  const std::size_t held = buffer_.size();
  buffer_.resize(held + read_size);
  const std::size_t n = source_(buffer_.data() + held, read_size);
  buffer_.resize(held + n);
  at_end_ = n == 0;
  return !at_end_;
}

/// Moves `length`, counted from begin_, from the start of a line to behind its end, reading as far as needed.
LineReader::Line LineReader::find_end(std::size_t& length) {
  std::size_t known = 0;  // bytes of the line in which there is no end
  while (true) {
    const std::size_t start = begin_ + length, newline = buffer_.find('\n', start + known);
    const std::size_t end = std::min(newline, buffer_.size());
    const bool blank = is_blank(std::string_view(buffer_).substr(start, end - start));
    if (!blank && (blanks_dropped_ || end - start > max_line)) return Line::too_long;
    if (newline != std::string::npos) {
      length = newline + 1 - begin_;
      blanks_dropped_ = false;
      return blank ? Line::ended : Line::whole;
    }
    known = end - start;
    if (known > max_line) {
      buffer_.erase(start);
      blanks_dropped_ = true;
      known = 0;
    }
    if (fill()) continue;
    length += known;
    return blank ? Line::ended : Line::whole;
  }
}

bool LineReader::next(LineBlock& block, std::size_t most_lines, std::size_t enough_bytes) {
  block.first_line = line_;
  block.lines = 0;
  block.too_long = false;
  std::size_t length = 0;
  while (block.lines < most_lines && length < enough_bytes && !block.too_long) {
    if (begin_ + length == buffer_.size() && !fill()) break;
    switch (find_end(length)) {
      case Line::whole:
        ++block.lines;
        ++line_;
        break;
      case Line::ended:
        ++line_;
        break;
      case Line::too_long:
        block.too_long = true;
        break;
    }
  }
  block.text.assign(buffer_, begin_, length);
  begin_ += length;
  if (block.too_long) {  // nothing behind it matters
    buffer_.clear();
    begin_ = 0;
    at_end_ = true;
  }
  return length > 0 || block.too_long;
}

LineReader::Source bytes_of(const std::string& path) {
  std::error_code ignored;
  if (path != "-" && std::filesystem::is_directory(path, ignored)) {
    throw bad_input(path, 0, "is a directory, expected a file");
  }
  const std::shared_ptr<std::FILE> file(path == "-" ? stdin : std::fopen(path.c_str(), "rb"), Closer());
  if (!file) throw cannot_read(path);
  return [file, path](char* buffer, std::size_t size) {
    const std::size_t n = std::fread(buffer, 1, size, file.get());
    if (n == 0 && std::ferror(file.get()) != 0) throw cannot_read(path);
    return n;
  };
}

LineReader::Source bytes_in(std::string_view text) {
  return [text](char* buffer, std::size_t size) mutable {
    const std::size_t n = std::min(size, text.size());
    std::memcpy(buffer, text.data(), n);
    text.remove_prefix(n);
    return n;
  };
}

LineReader::Source bytes_in(const Spool& text) {
  return [&text, offset = std::uint64_t{0}](char* buffer, std::size_t size) mutable {
    const std::string piece = text.at(offset, size);
    std::memcpy(buffer, piece.data(), piece.size());
    offset += piece.size();
    return piece.size();
  };
}

void for_each_line_of(const LineReader::Source& source, const std::function<void(std::string_view line)>& visit) {
  std::string buffer(read_size, '\0'), rest;
  while (const std::size_t n = source(buffer.data(), buffer.size())) {
    std::string_view text(buffer.data(), n);
    for (std::size_t end; (end = text.find('\n')) != std::string_view::npos; text.remove_prefix(end + 1)) {
      rest += text.substr(0, end);
      visit(rest);
      rest.clear();
    }
    rest += text;
  }
  if (!rest.empty()) visit(rest);
}

Rereadable::Rereadable(const std::string& path) : path_(path) {
  std::error_code ignored;
  if (path != "-" && (!std::filesystem::exists(path, ignored) || std::filesystem::is_regular_file(path, ignored) ||
                      std::filesystem::is_directory(path, ignored))) {
    return;
  }
  const LineReader::Source bytes = bytes_of(path);
  copy_.emplace();
  std::string buffer(read_size, '\0');
  while (const std::size_t n = bytes(buffer.data(), buffer.size())) copy_->write({buffer.data(), n});
}

LineReader::Source Rereadable::bytes() const { return copy_ ? bytes_in(*copy_) : bytes_of(path_); }

}  // namespace tribunal
