#include "exact/base/output.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "exact/base/failure.h"
#include "exact/base/fp_environment.h"
#include "exact/base/interrupt.h"
#include "exact/base/shown.h"
#include "exact/base/temporaries.h"

namespace tribunal {
namespace {

namespace fs = std::filesystem;

Failure output_failed(const std::string& path, int error) {
  return Failure(Exit::output_failed, path + ": cannot write: " + std::strerror(error));
}

// --- where a path leads ---------------------------------------------------------------------------------------------

/// What a path names once all links are followed.
struct Target {
  enum class Kind : std::uint8_t { fresh, regular, special, descriptor };

  std::string folder{}, name{};
  Kind kind = Kind::fresh;
  struct stat status {};  ///< if it is a regular file
  int descriptor = -1;    ///< of this process, where it is one

  std::string path() const { return folder + "/" + name; }
  bool is_direct() const { return kind == Kind::special || kind == Kind::descriptor; }
};

/// "/a/b" is ("/a", "b"), and "b" (".", "b").
std::pair<std::string, std::string> split(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return {".", path};
  return {slash == 0 ? "/" : path.substr(0, slash), path.substr(slash + 1)};
}

std::string canonical(const std::string& folder, const std::string& named) {
  char resolved[PATH_MAX];
  if (realpath(folder.c_str(), resolved) == nullptr) throw output_failed(named, errno);
  return resolved;
}

bool is_number(std::string_view text) {
  return !text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// "/proc/17/fd" and "/proc/17/task/18/fd" hold the descriptors of process 17.
bool holds_descriptors(const std::string& folder) { return folder.starts_with("/proc/") && folder.ends_with("/fd"); }

/// Of this process, or −1.
int own_descriptor(const Target& t) {
  const bool own = t.folder.starts_with("/proc/" + std::to_string(getpid()) + "/");
  return own && is_number(t.name) ? std::stoi(t.name) : -1;
}

std::string link_of(const std::string& path, const std::string& named) {
  char text[PATH_MAX];
  const ssize_t size = readlink(path.c_str(), text, sizeof text);
  if (size < 0) throw output_failed(named, errno);
  return {text, static_cast<std::size_t>(size)};
}

/// Follows links to the end, one that leads to nothing too: there the file is made.
Target target_of(const std::string& named) {
  constexpr int most_links = 40;
  std::string path = named;
  for (int i = 0; i < most_links; ++i) {
    const auto [parent, name] = split(path);
    if (name.empty()) throw output_failed(named, path.empty() ? ENOENT : EISDIR);
    Target t{.folder = canonical(parent, named), .name = name};
    if (holds_descriptors(t.folder)) {
      t.kind = Target::Kind::descriptor;
      t.descriptor = own_descriptor(t);
      return t;
    }
    if (lstat(t.path().c_str(), &t.status) != 0) {
      if (errno == ENOENT) return t;
      throw output_failed(named, errno);
    }
    if (S_ISDIR(t.status.st_mode)) throw output_failed(named, EISDIR);
    if (!S_ISLNK(t.status.st_mode)) {
      t.kind = S_ISREG(t.status.st_mode) ? Target::Kind::regular : Target::Kind::special;
      return t;
    }
    const std::string link = link_of(t.path(), named);
    path = link.starts_with("/") ? link : t.folder + "/" + link;
  }
  throw output_failed(named, ELOOP);
}

// --- descriptors ----------------------------------------------------------------------------------------------------

/// An open file, closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

  void write(std::string_view bytes, const std::string& named) const {
    while (!bytes.empty()) {
      const ssize_t n = ::write(number_, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) throw output_failed(named, errno);
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
  }

  /// Some file systems say only here that the disk is full.
  void flush(const std::string& named) const {
    if (fsync(number_) != 0 && errno != EINVAL && errno != ENOTSUP) throw output_failed(named, errno);
  }

  void close(const std::string& named) {
    if (::close(std::exchange(number_, -1)) != 0 && errno != EINTR) throw output_failed(named, errno);
  }

 private:
  int number_;
};

/// A descriptor of ours shares its offset, so that output goes on where it stood; all else is opened.
Descriptor open_direct(const Target& t, const std::string& named) {
  std::fflush(stdout);
  Descriptor opened(t.descriptor >= 0 ? fcntl(t.descriptor, F_DUPFD_CLOEXEC, 3)
                                      : open(t.path().c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY));
  if (!opened.is_open()) throw output_failed(named, errno);
  return opened;
}

void copy(int from, const Descriptor& to, const std::string& named) {
  std::array<char, 1 << 16> buffer;
  off_t at = 0;
  while (const ssize_t n = pread(from, buffer.data(), buffer.size(), at)) {
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw output_failed(named, errno);
    to.write({buffer.data(), static_cast<std::size_t>(n)}, named);
    at += n;
  }
}

std::shared_ptr<const Directory> open_directory(const std::string& folder, const std::string& named) try {
  return std::make_shared<const Directory>(folder);
} catch (const std::system_error& error) {
  throw output_failed(named, error.code().value());
}

/// Whether this process has put a result into its place.
std::atomic<bool> one_is_placed = false;

std::string not_written() { return one_is_placed ? "not all is written" : "nothing written"; }

}  // namespace

// --- one file -------------------------------------------------------------------------------------------------------

/// A file on its way to its place.
class OutputFile::Staged {
 public:
  explicit Staged(const std::string& path) : named_(path) {
    if (path == "-") {
      target_.kind = Target::Kind::descriptor;
      target_.descriptor = STDOUT_FILENO;
      named_ = "standard output";
      is_shown_ = true;
    } else {
      target_ = target_of(path);
    }
    if (target_.is_direct()) {
      file_ = open_direct(target_, named_);
    } else {
      require_writable();
      directory_ = open_directory(target_.folder, named_);
      create();
    }
  }

  /// A file that another process wrote.
  Staged(const std::string& from, const std::string& path) : named_(path), target_(target_of(path)) {
    const auto [parent, name] = split(from);
    adopted_ = open_directory(parent, named_);
    adopted_name_ = name;
    directory_ = open_directory(target_.folder, named_);
    file_ = open_staged();
    if (!target_.is_direct()) require_writable();
  }

  /// To standard output goes what shows as it is.
  void write(std::string_view bytes) {
    if (!is_shown_) return write_bytes(bytes);
    unshown_ += bytes;
    const std::size_t whole = whole_characters(unshown_);
    write_bytes(shown_lines(std::string_view(unshown_).substr(0, whole)));
    unshown_.erase(0, whole);
  }

  void write_bytes(std::string_view bytes) {
    if (buffer_.size() + bytes.size() < buffered) {
      buffer_ += bytes;
      return;
    }
    spill();
    file_.write(bytes, named_);
  }

  void spill() {
    refuse_changed_rounding();
    file_.write(buffer_, named_);
    buffer_.clear();
  }

  /// All that can fail before anything is changed. After it the file has its owner and mode, and is on the disk.
  void finish() {
    if (finished_) return;
    write_bytes(shown_lines(unshown_));
    unshown_.clear();
    spill();
    if (target_.kind == Target::Kind::regular) keep_owner_and_mode();
    if (temporary_ || adopted_) file_.flush(named_);
    if (temporary_ || !in_place_) file_.close(named_);
    finished_ = true;
  }

  /// Puts the file into its place. Returns whether that can be undone by renaming.
  bool place() {
    if (target_.is_direct()) {
      if (adopted_) copy(open_staged().number(), open_direct(target_, named_), named_);
      return false;
    }
    if (!in_place_ && rename_over()) return true;
    copy_over();
    return false;
  }

  std::string readable() {
    spill();
    return temporary_ ? target_.folder + "/" + temporary_->name() : "";
  }

  const std::string& named() const { return named_; }
  const Target& target() const { return target_; }
  std::shared_ptr<const Directory> directory() const { return directory_; }
  bool is_direct() const { return target_.is_direct(); }

 private:
  static constexpr std::size_t buffered = 1 << 16;

  void require_writable() const {
    if (target_.kind == Target::Kind::regular && faccessat(AT_FDCWD, target_.path().c_str(), W_OK, AT_EACCESS) != 0) {
      throw output_failed(named_, errno);
    }
  }

  /// Under a temporary name, or in memory where the folder takes no new file and the file is there.
  void create() {
    const bool fresh = target_.kind == Target::Kind::fresh;
    temporary_ = std::make_unique<Temporary>(directory_);
    file_ = Descriptor(openat(temporary_->directory(), temporary_->name(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC,
                              fresh ? 0666 : 0600));
    if (file_.is_open()) return;
    const int error = errno;
    temporary_->release();
    temporary_.reset();
    if (fresh || (error != EACCES && error != EPERM && error != EROFS)) throw output_failed(named_, error);
    in_place_ = true;
    file_ = Descriptor(memfd_create("tribunal", MFD_CLOEXEC));
    if (!file_.is_open()) throw output_failed(named_, errno);
  }

  void keep_owner_and_mode() {
    if (in_place_) return;
    struct stat own {};
    if (fstat(file_.number(), &own) != 0) throw output_failed(named_, errno);
    const struct stat& kept = target_.status;
    const bool same = own.st_uid == kept.st_uid && own.st_gid == kept.st_gid;
    if (!same && fchown(file_.number(), kept.st_uid, kept.st_gid) != 0) {
      in_place_ = true;
      return;
    }
    if (fchmod(file_.number(), kept.st_mode & 07777) != 0) throw output_failed(named_, errno);
  }

  int staged_in() const { return adopted_ ? adopted_->descriptor() : temporary_->directory(); }
  const char* staged_as() const { return adopted_ ? adopted_name_.c_str() : temporary_->name(); }

  Descriptor open_staged() const {
    Descriptor opened(openat(staged_in(), staged_as(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
    if (!opened.is_open()) throw output_failed(named_, errno);
    return opened;
  }

  /// False where the file is mounted, or lies on another file system than its name, or belongs to somebody else in a
  /// folder like /tmp.
  bool rename_over() {
    if (renameat(staged_in(), staged_as(), directory_->descriptor(), target_.name.c_str()) == 0) {
      if (temporary_) temporary_->release();
      return true;
    }
    const bool other_way = errno == EBUSY || errno == EXDEV || errno == EPERM || errno == EACCES;
    if (other_way && target_.kind == Target::Kind::regular) return false;
    throw output_failed(named_, errno);
  }

  void copy_over() {
    Descriptor out(openat(directory_->descriptor(), target_.name.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
    if (!out.is_open()) throw output_failed(named_, errno);
    const Descriptor staged = file_.is_open() ? std::move(file_) : open_staged();
    copy(staged.number(), out, named_);
    out.flush(named_);
    out.close(named_);
  }

  std::string named_;
  Target target_{};
  std::shared_ptr<const Directory> directory_{}, adopted_{};
  std::string adopted_name_{};
  std::unique_ptr<Temporary> temporary_{};
  Descriptor file_{};
  std::string buffer_{}, unshown_{};
  bool in_place_ = false;
  bool finished_ = false;
  bool is_shown_ = false;  ///< as people read it, who may be at a terminal (shown.h)
};

OutputFile::OutputFile(const std::string& path) : staged_(std::make_unique<Staged>(path)) {}
OutputFile::OutputFile(std::unique_ptr<Staged> staged) : staged_(std::move(staged)) {}
OutputFile::~OutputFile() = default;
OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;

void OutputFile::write(std::string_view bytes) {
  refuse_changed_rounding();
  staged_->write(bytes);
}

std::string OutputFile::readable() { return staged_->readable(); }

void OutputFile::commit(AfterSignal after) {
  refuse_changed_rounding();
  staged_->finish();
  const UnbrokenEnd unbroken;
  if (after == AfterSignal::nothing) fail_if_interrupted(not_written());
  staged_->place();
  one_is_placed = true;
}

void write_file(const std::string& path, std::string_view bytes, AfterSignal after) {
  OutputFile file(path);
  file.write(bytes);
  file.commit(after);
}

// --- files that appear together -------------------------------------------------------------------------------------

class OutputSet::Files {
 public:
  std::vector<std::unique_ptr<OutputFile>> files{};
  std::vector<std::string> dropped{};

  void finish() {
    for (const auto& file : files) staged(*file).finish();
  }

  void place_all() {
    try {
      files.empty() ? remove_dropped() : place_result();
    } catch (...) {
      undo();
      throw;
    }
  }

 private:
  /// A file that was there, under a temporary name until the set is complete.
  struct Moved {
    std::shared_ptr<const Directory> directory;
    std::string name;
    std::unique_ptr<Temporary> aside;
  };
  /// A file that was put in its place.
  struct Placed {
    std::shared_ptr<const Directory> directory;
    std::string name;
  };

  static OutputFile::Staged& staged(OutputFile& file) { return *file.staged_; }

  void place_result() {
    OutputFile::Staged& last = staged(*files.back());
    if (files.size() > 1 || !dropped.empty())
      move_aside(last);  // one file alone is renamed over the one that was there
    remove_dropped();
    for (const auto& file : files) {
      OutputFile::Staged& f = staged(*file);
      if (&f != &last) move_aside(f);
      place(f);
    }
  }

  void place(OutputFile::Staged& f) {
    if (f.place())
      placed_.push_back({f.directory(), f.target().name});
    else if (!f.is_direct())
      overwritten_ = true;
  }

  void move_aside(const OutputFile::Staged& f) {
    if (f.target().kind == Target::Kind::regular) move_aside(f.directory(), f.target().name, f.named(), true);
  }

  /// A file that is not there need not move; one that cannot, if it may stay, is overwritten, and that cannot be
  /// undone.
  void move_aside(const std::shared_ptr<const Directory>& directory, const std::string& name, const std::string& named,
                  bool may_stay) {
    auto aside = std::make_unique<Temporary>(directory);
    if (renameat(directory->descriptor(), name.c_str(), aside->directory(), aside->name()) == 0) {
      moved_.push_back({directory, name, std::move(aside)});
      return;
    }
    const int error = errno;
    aside->release();
    if (error == ENOENT || (may_stay && (error == EBUSY || error == EPERM || error == EACCES))) return;
    throw output_failed(named, error);
  }

  void remove_dropped() {
    for (const std::string& path : dropped) {
      const auto [folder, name] = split(path);
      move_aside(open_directory(folder, path), name, path, false);
    }
  }

  /// The other way round. What cannot be put back stays under no name: without the last file it is no result anyway.
  void undo() {
    for (; !placed_.empty(); placed_.pop_back()) {
      unlinkat(placed_.back().directory->descriptor(), placed_.back().name.c_str(), 0);
    }
    const std::string last = files.empty() ? "" : staged(*files.back()).target().name;
    for (; !moved_.empty(); moved_.pop_back()) {
      Moved& m = moved_.back();
      if (overwritten_ && m.name == last) continue;  // its companions are not what they were
      if (renameat(m.aside->directory(), m.aside->name(), m.directory->descriptor(), m.name.c_str()) == 0) {
        m.aside->release();
      }
    }
  }

  std::vector<Moved> moved_{};
  std::vector<Placed> placed_{};
  bool overwritten_ = false;
};

OutputSet::OutputSet() : files_(std::make_unique<Files>()) {}
OutputSet::~OutputSet() = default;
OutputSet::OutputSet(OutputSet&&) noexcept = default;
OutputSet& OutputSet::operator=(OutputSet&&) noexcept = default;

OutputFile& OutputSet::open(const std::string& path) {
  return *files_->files.emplace_back(std::make_unique<OutputFile>(path));
}

void OutputSet::add(const std::string& path, std::string_view bytes) { open(path).write(bytes); }

void OutputSet::adopt(const std::string& from, const std::string& path) {
  OutputFile file(std::make_unique<OutputFile::Staged>(from, path));
  files_->files.push_back(std::make_unique<OutputFile>(std::move(file)));
}

void OutputSet::prepare() {
  refuse_changed_rounding();
  files_->finish();
}

void OutputSet::drop(const std::string& path) { files_->dropped.push_back(path); }

void OutputSet::commit(AfterSignal after) {
  refuse_changed_rounding();
  files_->finish();
  const UnbrokenEnd unbroken;
  if (after == AfterSignal::nothing) fail_if_interrupted(not_written());
  files_->place_all();
  one_is_placed = true;
  *this = OutputSet();
}

// --- directories ----------------------------------------------------------------------------------------------------

void make_directory(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (!error && !fs::is_directory(path, error) && !error) error = {ENOTDIR, std::generic_category()};
  if (error) throw output_failed(path, error.value());
}

void remove_tree(const std::string& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error) throw Failure(Exit::output_failed, path + ": cannot be removed: " + error.message());
}

TemporaryDirectory::TemporaryDirectory(const std::string& parent) {
  static unsigned numbers = 0;
  int error = EEXIST;
  while (error == EEXIST) {
    path_ = parent + "/.tribunal-" + std::to_string(getpid()) + "-figures-" + std::to_string(numbers++) + ".tmp";
    error = mkdir(path_.c_str(), 0777) == 0 ? 0 : errno;
  }
  if (error != 0) throw output_failed(parent, error);
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code error;
  fs::remove_all(path_, error);
  if (error) fs::remove_all(path_, error);  // what failed once, as under memory pressure, may succeed now
}

bool is_special(const std::string& path) {
  try {
    return path == "-" || target_of(path).is_direct();
  } catch (const Failure&) {
    return false;
  }
}

}  // namespace tribunal
