// The temporary files of this process, which whatever ends it removes.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace tribunal {

/// An open directory, by which its files are named however long its path is.
class Directory {
 public:
  /// Throws std::system_error.
  explicit Directory(const std::string& path);
  ~Directory();
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;

  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

/// A short name in a directory that no file has, ".tribunal-PID-N.tmp", known to remove_temporaries() until it is
/// released. The destructor removes the file that has it, if there is one.
class Temporary {
 public:
  explicit Temporary(std::shared_ptr<const Directory> directory);
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  const char* name() const;
  int directory() const { return directory_->descriptor(); }

  /// The file has another name by now, or none.
  void release();

  struct Slot;

 private:
  std::shared_ptr<const Directory> directory_;
  Slot* slot_;
};

/// Removes all temporary files of this process. Safe in a signal handler.
void remove_temporaries() noexcept;

}  // namespace tribunal
