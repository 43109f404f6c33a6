#include "exact/base/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <system_error>

#include "exact/base/failure.h"
#include "exact/base/fp_environment.h"
#include "exact/base/sudden_end.h"

namespace tribunal {
namespace {

namespace fs = std::filesystem;

struct Closer {
  void operator()(std::FILE* f) const {
    if (f != stdin) std::fclose(f);
  }
};
using File = std::unique_ptr<std::FILE, Closer>;

Failure output_failed(const std::string& path, int error) {
  return Failure(Exit::output_failed, path + ": cannot write: " + std::strerror(error));
}

void write_all(std::FILE* out, std::string_view bytes, const std::string& name) {
  errno = 0;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size() && std::fflush(out) == 0;
  if (!written) throw output_failed(name, errno);
}

/// `name` is what messages call the file.
void write_in_place(const std::string& path, std::string_view bytes, const std::string& name) {
  const File out(std::fopen(path.c_str(), "wb"));
  if (!out) throw output_failed(name, errno);
  write_all(out.get(), bytes, name);
}

/// The temporary file that is being written, for a sudden end to remove; empty where there is none.
char unfinished[4096];

void remove_unfinished() noexcept {
  if (unfinished[0] != 0) unlink(unfinished);
}

/// Holds the name of a temporary file in `unfinished`. A longer name is not kept: the system takes none.
class Unfinished {
 public:
  explicit Unfinished(const std::string& path) {
    if (path.size() < sizeof unfinished) std::memcpy(unfinished, path.c_str(), path.size() + 1);
    before_sudden_end(remove_unfinished);
  }
  ~Unfinished() { unfinished[0] = 0; }
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
};

/// The name that the file has or would have, absolute, without links and "..".
fs::path resolved(const std::string& path) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);  // weakly_canonical leaves "b.png" relative, and not "./b.png"
  const fs::path found = fs::weakly_canonical(whole, error);
  return error ? whole.lexically_normal() : found;
}

}  // namespace

/// A device or a pipe cannot be renamed over; it is written in place.
bool is_special(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

std::string read_file(const std::string& path, std::size_t limit) {
  if (path != "-" && fs::is_directory(path)) throw bad_input(path, 0, "is a directory, expected a file");
  const File in(path == "-" ? stdin : std::fopen(path.c_str(), "rb"));
  if (!in) throw bad_input(path, 0, std::string("cannot read: ") + std::strerror(errno));
  std::string bytes;
  char buffer[1 << 16];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, in.get())) {
    bytes.append(buffer, n);
    if (bytes.size() > limit) throw bad_input(path, 0, "is larger than " + std::to_string(limit) + " bytes");
  }
  if (std::ferror(in.get())) throw bad_input(path, 0, std::string("cannot read: ") + std::strerror(errno));
  return bytes;
}

void write_file(const std::string& path, std::string_view bytes) {
  refuse_changed_rounding();
  if (path == "-") return print(bytes);
  if (is_special(path)) return write_in_place(path, bytes, path);
  const std::string temporary = path + ".tmp" + std::to_string(getpid());
  const Unfinished known(temporary);
  try {
    write_in_place(temporary, bytes, path);
    std::error_code error;
    fs::rename(temporary, path, error);
    if (error) throw output_failed(path, error.value());
  } catch (...) {
    std::remove(temporary.c_str());
    throw;
  }
}

void make_directory(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path)) throw output_failed(path, error ? error.value() : ENOTDIR);
}

void print(std::string_view text) {
  refuse_changed_rounding();
  write_all(stdout, text, "standard output");
}

void require_different(const std::string& input, const std::string& output) {
  std::error_code ignored;
  if (input != "-" && output != "-" && fs::equivalent(input, output, ignored)) {
    throw Failure(Exit::usage, output + ": output is the same file as the input");
  }
}

void require_distinct(const std::vector<Output>& outputs) {
  std::map<fs::path, const Output*> owners;
  for (const Output& o : outputs) {
    const auto [owner, fresh] = owners.emplace(resolved(o.file), &o);
    if (fresh) continue;
    throw Failure(Exit::usage, owner->second->option + " and " + o.option + " would both write " + o.file +
                                   ", expected different files");
  }
}

}  // namespace tribunal
