// The program's own malloc and pthread_create: those of the system, which end the program with exit code 7 and one line
// where they fail.
//
// Whatever is linked here calls them: our code, the C and C++ libraries, GMP, MPFR, OpenSSL, TBB. Several of these
// cannot report that memory is missing: GMP aborts; the C library aborts where it registers the destructor of a
// thread's variable; std::getline ends as at the end of the file; what is thrown from a noexcept function ends in
// std::terminate, as does TBB where a thread does not start. None of that happens where a call that fails never
// returns. A plugin gets the system's answer, since what it does then is its own affair.
//
// Every thread of ours, TBB's too, begins here as well: in the floating-point environment and the locale that the
// program computes in, whatever a library in between has made of them.
//
// This file is part of the program and of no library: who links ours has an allocator of his own. Sanitizers replace
// the same functions, and a build with one goes without.
#include <dlfcn.h>
#include <pthread.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>

#include "exact/base/foreign_code.h"
#include "exact/base/parallel.h"
#include "exact/base/sudden_end.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TRIBUNAL_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define TRIBUNAL_SANITIZED
#endif
#endif

#ifndef TRIBUNAL_SANITIZED
namespace {

using tribunal::end_without_memory;
using tribunal::ForeignCode;

/// The next definition of a function after ours, looked up once. Two threads that look at the same time find the same.
template <class Function>
class Next {
 public:
  explicit constexpr Next(const char* name) : name_(name) {}

  Function* get() {
    if (Function* const found = __atomic_load_n(&function_, __ATOMIC_RELAXED)) return found;
    auto* const found = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name_));
    if (found == nullptr) tribunal::end_at_once(tribunal::Exit::resources, "no memory allocator");
    __atomic_store_n(&function_, found, __ATOMIC_RELAXED);
    return found;
  }

 private:
  const char* name_;
  Function* function_ = nullptr;
};

constinit Next<void*(std::size_t)> next_malloc("malloc");
constinit Next<void*(std::size_t, std::size_t)> next_calloc("calloc");
constinit Next<void*(void*, std::size_t)> next_realloc("realloc");
constinit Next<void*(std::size_t, std::size_t)> next_aligned_alloc("aligned_alloc");
constinit Next<void*(std::size_t, std::size_t)> next_memalign("memalign");
constinit Next<int(void**, std::size_t, std::size_t)> next_posix_memalign("posix_memalign");
constinit Next<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)> next_pthread_create("pthread_create");

/// The block, which is null only where a plugin asked for it, or asked of realloc to free.
void* checked(void* block) {
  if (block == nullptr && !ForeignCode::runs_here()) [[unlikely]]
    end_without_memory();
  return block;
}

struct Start {
  void* (*run)(void*);
  void* with;
};

/// Before static objects are made, as is the repair of the floating-point environment. All are looked up here: where
/// the first call of one comes from inside dlopen, dlsym would free the state of an error that dlopen still writes to.
[[gnu::constructor(101)]] void install_early() {
  tribunal::install_last_resort();
  next_malloc.get();
  next_calloc.get();
  next_realloc.get();
  next_aligned_alloc.get();
  next_memalign.get();
  next_posix_memalign.get();
  next_pthread_create.get();
}

/// A thread of ours. Where its environment cannot be repaired, the exception ends the program.
extern "C" void* begin(void* given) {
  const Start start = *static_cast<Start*>(given);
  std::free(given);
  tribunal::begin_thread();
  return start.run(start.with);
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) noexcept { return checked(next_malloc.get()(size)); }

void* calloc(std::size_t count, std::size_t size) noexcept { return checked(next_calloc.get()(count, size)); }

void* realloc(void* block, std::size_t size) noexcept {
  void* const moved = next_realloc.get()(block, size);
  return size == 0 && block != nullptr ? moved : checked(moved);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return checked(next_aligned_alloc.get()(alignment, size));
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return checked(next_memalign.get()(alignment, size));
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  const int error = next_posix_memalign.get()(block, alignment, size);
  if (error == ENOMEM && !ForeignCode::runs_here()) end_without_memory();
  return error;
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* with) noexcept {
  if (ForeignCode::runs_here()) return next_pthread_create.get()(thread, attributes, run, with);
  auto* const start = static_cast<Start*>(malloc(sizeof(Start)));
  *start = {run, with};
  if (next_pthread_create.get()(thread, attributes, begin, start) != 0) {
    tribunal::end_at_once(tribunal::Exit::resources, "cannot start a thread");
  }
  return 0;
}
}
#endif
