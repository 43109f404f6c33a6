#include "exact/base/temporaries.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <mutex>
#include <system_error>
#include <utility>

namespace tribunal {

/// A name while `directory` is not −1. Slots are never freed, so a signal handler may walk their list at any time.
struct Temporary::Slot {
  std::atomic<int> directory{-1};
  char name[48]{};
  bool taken = false;
  Slot* next = nullptr;
};

namespace {

std::atomic<Temporary::Slot*> first_slot{nullptr};
std::mutex slots_guard;

/// A slot that is not taken, or a new one at the head of the list.
Temporary::Slot* take_slot() {
  const std::scoped_lock lock(slots_guard);
  for (Temporary::Slot* slot = first_slot; slot != nullptr; slot = slot->next) {
    if (!std::exchange(slot->taken, true)) return slot;
  }
  auto* const slot = new Temporary::Slot;
  slot->taken = true;
  slot->next = first_slot;
  first_slot = slot;
  return slot;
}

bool exists(int directory, const char* name) {
  struct stat status {};
  return fstatat(directory, name, &status, AT_SYMLINK_NOFOLLOW) == 0;
}

}  // namespace

Directory::Directory(const std::string& path) : descriptor_(open(path.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category());
}

Directory::~Directory() { close(descriptor_); }

Temporary::Temporary(std::shared_ptr<const Directory> directory)
    : directory_(std::move(directory)), slot_(take_slot()) {
  static std::atomic<unsigned> numbers{0};
  do {
    std::snprintf(slot_->name, sizeof slot_->name, ".tribunal-%ld-%u.tmp", static_cast<long>(getpid()), numbers++);
  } while (exists(this->directory(), slot_->name));  // a leftover of a process that was killed
  slot_->directory = this->directory();
}

Temporary::~Temporary() {
  if (slot_->directory >= 0) unlinkat(directory(), name(), 0);
  release();
  const std::scoped_lock lock(slots_guard);
  slot_->taken = false;
}

const char* Temporary::name() const { return slot_->name; }

void Temporary::release() { slot_->directory = -1; }

void remove_temporaries() noexcept {
  for (const Temporary::Slot* slot = first_slot; slot != nullptr; slot = slot->next) {
    const int directory = slot->directory;
    if (directory >= 0) unlinkat(directory, slot->name, 0);
  }
}

}  // namespace tribunal
