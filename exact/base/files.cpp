#include "exact/base/files.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <system_error>

#include "exact/base/failure.h"
#include "exact/base/fp_environment.h"
#include "exact/base/shown.h"

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

/// Fails with Exit::bad_input where the system refuses to say.
fs::file_status status_of(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::none) throw bad_input(path, 0, "cannot read: " + error.message());
  return status;
}

/// The paths of those entries that are wanted, sorted. A step that fails ends the walk: the iterator is then equal to
/// the end.
template <class Iterator, class Wanted>
std::vector<std::string> walk(const std::string& directory, const Wanted& wanted) {
  std::error_code error;
  std::vector<std::string> paths;
  Iterator at(directory, error);
  if (error) throw bad_input(directory, 0, "cannot be read as a directory (" + error.message() + ")");
  std::string last = directory;
  for (; at != Iterator(); at.increment(error)) {
    last = at->path().string();
    if (wanted(*at)) paths.push_back(last);
  }
  if (error) throw bad_input(last, 0, "cannot be read, or what follows it (" + error.message() + ")");
  std::ranges::sort(paths);
  return paths;
}

/// The name that the file has or would have, absolute, without links and "..".
fs::path resolved(const std::string& path) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);  // weakly_canonical leaves "b.png" relative, and not "./b.png"
  const fs::path found = fs::weakly_canonical(whole, error);
  return error ? whole.lexically_normal() : found;
}

}  // namespace

bool exists(const std::string& path) { return status_of(path).type() != fs::file_type::not_found; }

bool is_directory(const std::string& path) { return fs::is_directory(status_of(path)); }

bool is_regular_file(const std::string& path) { return fs::is_regular_file(status_of(path)); }

std::vector<std::string> files_in(const std::string& directory) {
  return walk<fs::directory_iterator>(directory, [](const fs::directory_entry&) { return true; });
}

std::vector<std::string> files_below(const std::string& directory) {
  return walk<fs::recursive_directory_iterator>(directory, [](const fs::directory_entry& entry) {
    std::error_code unknown;
    return entry.is_regular_file(unknown);
  });
}

std::string program_file() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).string();
}

std::string canonical_path(const std::string& path) { return resolved(path).string(); }

std::string read_file(const std::string& path, std::size_t limit) {
  if (path != "-" && is_directory(path)) throw bad_input(path, 0, "is a directory, expected a file");
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

void print(std::string_view text) {
  refuse_changed_rounding();
  write_all(stdout, shown_lines(text), "standard output");
}

void require_different(const std::string& input, const std::string& output) {
  std::error_code ignored;
  if (input != "-" && output != "-" && fs::is_regular_file(output, ignored) && fs::equivalent(input, output, ignored)) {
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
