// The only door through which the program writes, renames and removes files.
//
// Laws. (1) A file appears whole or not at all: it is written under a temporary name beside its place,
// ".tribunal-PID-N.tmp", flushed to the disk and renamed. (2) A link is followed: what it points to is replaced, and
// the link stays. (3) A file that was there keeps its owner and its mode; one that may not be written to is left alone;
// a new one obeys the umask. (4) What cannot be renamed over is written to directly: devices, pipes, descriptors
// ("/dev/stdout", "/dev/fd/3"), a file alone in a folder where nothing may be made, a mounted one, one whose owner only
// its owner could keep. Regular files among these are written under a temporary name first, and copied. (5) Every
// failure is Exit::output_failed, names the file as the caller did, leaves no temporary file and all that was there as
// it was. (6) After a signal that asked for an end nothing appears any more, unless the caller saves what was found:
// Failure with 128 + signal. (7) Nothing is written once the floating-point environment has changed
// (fp_environment.h): what follows it may be wrong.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal {

/// Whether files may still appear after a signal that asked for an end.
enum class AfterSignal : bool { nothing, appears };

/// One file, written from begin to end. "-" is standard output, which gets what shows as it is (shown.h).
/// It appears by commit(); without that, nothing does, but for what went to a device or pipe directly.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) noexcept;

  /// Appends. May keep some of it until more comes.
  void write(std::string_view bytes);

  void commit(AfterSignal = AfterSignal::nothing);

  /// All that was written so far can be read from here until commit(), where the file can be renamed into its place;
  /// else empty.
  std::string readable();

 private:
  friend class OutputSet;
  class Staged;
  explicit OutputFile(std::unique_ptr<Staged> staged);

  std::unique_ptr<Staged> staged_;
};

/// Files that become visible together. The last one added is what makes the others a result (summary.json): of an
/// earlier result it disappears first, and of this one it appears last. So whenever the program is stopped, by
/// whatever, the directory holds the earlier result, or this one, or files without the last, which nobody takes for a
/// result. If a step fails, those before it are undone.
class OutputSet {
 public:
  OutputSet();
  ~OutputSet();
  OutputSet(OutputSet&&) noexcept;
  OutputSet& operator=(OutputSet&&) noexcept;

  /// A file to be written until commit(). Valid until then.
  OutputFile& open(const std::string& path);
  void add(const std::string& path, std::string_view bytes);

  /// A file that was written elsewhere on the same file system, and is renamed.
  void adopt(const std::string& from, const std::string& path);

  /// A file of an earlier result, removed by commit() if it is there.
  void drop(const std::string& path);

  /// Writes to the end what commit() renames: what can fail for want of space or leave, fails here. Of several sets of
  /// one command each is prepared before the first is committed.
  void prepare();

  void commit(AfterSignal = AfterSignal::nothing);

 private:
  class Files;
  std::unique_ptr<Files> files_;
};

/// One file at once.
void write_file(const std::string& path, std::string_view bytes, AfterSignal = AfterSignal::nothing);

/// Creates the directory and its parents.
void make_directory(const std::string& path);

/// Removes the file, or the directory with all that is in it, if it is there. Does not follow a link.
void remove_tree(const std::string& path);

/// A directory for a child process to write to, below another; removed with all that is in it.
class TemporaryDirectory {
 public:
  explicit TemporaryDirectory(const std::string& parent);
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Whether the path names what is written to directly, and has no contents to lose: a device, a pipe, a descriptor.
bool is_special(const std::string& path);

}  // namespace tribunal
