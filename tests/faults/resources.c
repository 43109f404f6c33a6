/* Preloaded, makes the FAULT_AT-th call fail of those that FAULT_WHAT names, and where FAULT_ON is "after" all that
   follow: memory: malloc, calloc, realloc, aligned_alloc, memalign, posix_memalign; map: mmap; threads: pthread_create.
   The file FAULT_FIRED is made when the first call fails; FAULT_COUNT gets the number of calls when the program ends.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);

enum what { unknown, nothing, memory, map, threads };

static enum what what = unknown;
static long at = 0, calls = 0, copies = 0;
static int after = 0, each = 0;

static void read_environment(void) {
  const char* const name = getenv("FAULT_WHAT");
  const char* const on = getenv("FAULT_ON");
  const char* const number = getenv("FAULT_AT");
  at = number != NULL ? atol(number) : 0;
  after = on != NULL && strcmp(on, "after") == 0;
  each = on != NULL && strcmp(on, "each") == 0;
  what = name == NULL                   ? nothing
         : strcmp(name, "memory") == 0  ? memory
         : strcmp(name, "map") == 0     ? map
         : strcmp(name, "threads") == 0 ? threads
                                        : nothing;
}

static void note_other(long n) {
  char line[32];
  const int length = snprintf(line, sizeof line, "%ld\n", n);
  const int file = open(getenv("FAULT_OTHERS"), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0 || write(file, line, (size_t)length) != length) _exit(97);
  close(file);
}

/* Whether this process is the copy in which the n-th call fails. */
static int is_copy(long n) {
  const int errno_before = errno;
  int ends[2], status = 0;
  if (pipe2(ends, O_CLOEXEC) != 0) _exit(96);
  const pid_t copy = _Fork();
  if (copy < 0) _exit(95);
  if (copy == 0) {
    at = 0;
    unsetenv("FAULT_COUNT");
    dup2(ends[1], STDERR_FILENO);
    dup2(ends[1], STDOUT_FILENO);
    alarm(20);
    return 1;
  }
  __atomic_add_fetch(&copies, 1, __ATOMIC_RELAXED);
  close(ends[1]);
  char said[256];
  size_t length = 0;
  for (ssize_t more = 1; more > 0 && length < sizeof said - 1; length += (size_t)more) {
    more = read(ends[0], said + length, sizeof said - 1 - length);
    if (more < 0) more = 0;
  }
  said[length] = 0;
  close(ends[0]);
  while (waitpid(copy, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 7 || strcmp(said, getenv("FAULT_LINE")) != 0) note_other(n);
  errno = errno_before;
  return 0;
}

/* Whether this call is to fail. Calls before the C library knows the environment are not counted. */
static int fails(enum what kind) {
  if (what == unknown) {
    if (environ == NULL) return 0;
    read_environment();
  }
  if (what != kind) return 0;
  const long n = __atomic_add_fetch(&calls, 1, __ATOMIC_RELAXED);
  if (each && at > 0) {
    if (n % at != 0 || !is_copy(n)) return 0;
    errno = ENOMEM;
    return 1;
  }
  if (at == 0 || (after ? n < at : n != at)) return 0;
  if (n == at && getenv("FAULT_FIRED") != NULL) {
    const int file = open(getenv("FAULT_FIRED"), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    if (file >= 0) close(file);
  }
  errno = kind == threads ? EAGAIN : ENOMEM;
  return 1;
}

/* Python, which draws figures, is not on trial. */
__attribute__((constructor)) static void at_start(void) { unsetenv("LD_PRELOAD"); }

__attribute__((destructor)) static void at_end(void) {
  const char* const name = getenv("FAULT_COUNT");
  if (name == NULL) return;
  char text[64];
  const int length = snprintf(text, sizeof text, "%ld %ld\n", calls, copies);
  const int file = open(name, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file < 0 || write(file, text, (size_t)length) != length) _exit(99);
  close(file);
}

void* malloc(size_t size) { return fails(memory) ? NULL : __libc_malloc(size); }
void* calloc(size_t count, size_t size) { return fails(memory) ? NULL : __libc_calloc(count, size); }
void* realloc(void* block, size_t size) { return fails(memory) ? NULL : __libc_realloc(block, size); }
void* memalign(size_t alignment, size_t size) { return fails(memory) ? NULL : __libc_memalign(alignment, size); }
void* aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }

int posix_memalign(void** block, size_t alignment, size_t size) {
  *block = memalign(alignment, size);
  return *block == NULL ? ENOMEM : 0;
}

void* mmap(void* where, size_t size, int protection, int flags, int file, off_t offset) {
  static void* (*real)(void*, size_t, int, int, int, off_t);
  if (real == NULL) real = (void* (*)(void*, size_t, int, int, int, off_t))dlsym(RTLD_NEXT, "mmap");
  return fails(map) ? MAP_FAILED : real(where, size, protection, flags, file, offset);
}
void* mmap64(void* where, size_t size, int protection, int flags, int file, off_t offset) {
  return mmap(where, size, protection, flags, file, offset);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* with) {
  static int (*real)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  if (real == NULL) {
    real = (int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*))dlsym(RTLD_NEXT, "pthread_create");
  }
  return fails(threads) ? EAGAIN : real(thread, attributes, run, with);
}
