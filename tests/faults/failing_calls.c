/* A library to preload: the FAIL_AT-th call of those below, counted together, fails with FAIL_ERRNO, and the file
 * FAIL_MARK is made and holds "number call what", so that the caller knows which it was: of a call that is given a
 * descriptor, `what` is "reading NAME", "writing NAME", or "unnamed" for a file that no directory holds. With FAIL_SHORT a write succeeds instead, by
 * one byte. FAIL_AT=0 fails none. FAIL_LOG is given one line a call. FAIL_PYTHON is run instead of any other program.
 * Children are not touched, and a name that starts with one of FAIL_SKIP (separated by ':') does not count: the
 * program's libraries open files of their own.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdio_ext.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

static long fail_at;
static int fail_errno, fail_short;
static char mark[4096], log_file[4096], skip[4096], python[4096];
static atomic_long calls;

static void keep(char* to, const char* name) {
  const char* const value = getenv(name);
  if (value != NULL && strlen(value) < 4096) strcpy(to, value);
}

__attribute__((constructor)) static void start(void) {
  const char* const at = getenv("FAIL_AT");
  const char* const error = getenv("FAIL_ERRNO");
  fail_at = at != NULL ? atol(at) : 0;
  fail_errno = error != NULL ? atoi(error) : EIO;
  fail_short = getenv("FAIL_SHORT") != NULL;
  keep(mark, "FAIL_MARK");
  keep(log_file, "FAIL_LOG");
  keep(skip, "FAIL_SKIP");
  keep(python, "FAIL_PYTHON");
  unsetenv("LD_PRELOAD");
}

static void append(const char* file, const char* text) {
  if (file[0] == '\0') return;
  const long out = syscall(SYS_openat, AT_FDCWD, file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (out < 0) return;
  syscall(SYS_write, out, text, strlen(text));
  syscall(SYS_close, out);
}

static int is_skipped(const char* name) {
  const char* prefix = skip;
  while (*prefix != '\0') {
    const size_t length = strcspn(prefix, ":");
    if (length > 0 && strncmp(name, prefix, length) == 0) return 1;
    prefix += length;
    prefix += *prefix == ':';
  }
  return 0;
}

/* Stands for a name that does not count. */
static const char skipped[] = "";

/* Whether this call is the one. `name`: of the file, or NULL. */
static int fails(const char* call, const char* name) {
  char line[4300];
  if (fail_short && strcmp(call, "write") != 0) return 0;
  if (name == skipped || (name != NULL && is_skipped(name))) return 0;
  const long number = atomic_fetch_add(&calls, 1) + 1;
  snprintf(line, sizeof line, "%ld %s %s\n", number, call, name != NULL ? name : "");
  append(log_file, line);
  if (number != fail_at) return 0;
  append(mark, line);
  errno = fail_errno;
  return 1;
}

/* What a descriptor is open for. */
static const char* use_of(int fd) {
  static _Thread_local char text[4200];
  char link[32], name[4096];
  struct stat status;
  const int flags = fcntl(fd, F_GETFL);
  if (flags < 0 || fstat(fd, &status) != 0) return "nothing";
  if ((flags & O_ACCMODE) != O_RDONLY && status.st_nlink == 0) return "unnamed";
  snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  const long length = syscall(SYS_readlinkat, AT_FDCWD, link, name, sizeof name - 1);
  name[length < 0 ? 0 : length] = '\0';
  if (is_skipped(name)) return skipped;
  snprintf(text, sizeof text, "%s %s", (flags & O_ACCMODE) == O_RDONLY ? "reading" : "writing", name);
  return text;
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

#define OPEN(name)                                                                \
  int name(const char* path, int flags, ...) {                                    \
    va_list list;                                                                 \
    va_start(list, flags);                                                        \
    const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(list, mode_t) : 0; \
    va_end(list);                                                                 \
    return fails(#name, path) ? -1 : REAL(name)(path, flags, mode);               \
  }
#define OPENAT(name)                                                              \
  int name(int at, const char* path, int flags, ...) {                            \
    va_list list;                                                                 \
    va_start(list, flags);                                                        \
    const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(list, mode_t) : 0; \
    va_end(list);                                                                 \
    return fails(#name, path) ? -1 : REAL(name)(at, path, flags, mode);           \
  }
OPEN(open)
OPEN(open64)
OPENAT(openat)
OPENAT(openat64)

FILE* fopen(const char* path, const char* mode) { return fails("fopen", path) ? NULL : REAL(fopen)(path, mode); }
FILE* fopen64(const char* path, const char* mode) { return fails("fopen64", path) ? NULL : REAL(fopen64)(path, mode); }

/* What goes to standard error is not counted: nobody could say that it failed. */
ssize_t write(int fd, const void* bytes, size_t size) {
  if (fd != STDERR_FILENO && fails("write", use_of(fd))) {
    if (!fail_short) return -1;
    return syscall(SYS_write, fd, bytes, size > 0 ? 1 : 0);
  }
  return syscall(SYS_write, fd, bytes, size);
}

ssize_t read(int fd, void* bytes, size_t size) {
  if (fails("read", use_of(fd))) return -1;
  return syscall(SYS_read, fd, bytes, size);
}

/* The descriptor is closed, as Linux does it. */
int close(int fd) {
  const int failed = fails("close", use_of(fd));
  const int result = (int)syscall(SYS_close, fd);
  if (failed) errno = fail_errno;
  return failed ? -1 : result;
}

/* The disk, which takes its time, is not waited for: nobody turns the power off. */
int fsync(int fd) { return fails("fsync", use_of(fd)) ? -1 : 0; }

#define SIMPLE(type, name, parameters, arguments, path) \
  type name parameters { return fails(#name, path) ? -1 : REAL(name) arguments; }
SIMPLE(int, fchmod, (int fd, mode_t mode), (fd, mode), use_of(fd))
SIMPLE(int, fchown, (int fd, uid_t u, gid_t g), (fd, u, g), use_of(fd))
SIMPLE(ssize_t, pread, (int fd, void* to, size_t size, off_t at), (fd, to, size, at), use_of(fd))
SIMPLE(ssize_t, pread64, (int fd, void* to, size_t size, off64_t at), (fd, to, size, at), use_of(fd))
SIMPLE(ssize_t, pwrite, (int fd, const void* from, size_t size, off_t at), (fd, from, size, at), use_of(fd))
SIMPLE(ssize_t, pwrite64, (int fd, const void* from, size_t size, off64_t at), (fd, from, size, at), use_of(fd))
SIMPLE(int, mkstemp, (char* name), (name), name)
SIMPLE(int, mkstemp64, (char* name), (name), name)
SIMPLE(int, memfd_create, (const char* name, unsigned flags), (name, flags), name)
SIMPLE(int, rename, (const char* a, const char* b), (a, b), b)
SIMPLE(int, renameat, (int d, const char* a, int e, const char* b), (d, a, e, b), b)
SIMPLE(int, fflush, (FILE * f), (f), f == stderr ? skipped : f != NULL && __fpending(f) == 0 ? "nothing" : "what waits")
SIMPLE(int, mkdir, (const char* path, mode_t mode), (path, mode), path)

int posix_spawnp(pid_t* pid, const char* file, const posix_spawn_file_actions_t* actions,
                 const posix_spawnattr_t* attributes, char* const arguments[], char* const environment[]) {
  if (fails("posix_spawnp", file)) return fail_errno;
  return REAL(posix_spawnp)(pid, python[0] != '\0' ? python : file, actions, attributes, arguments, environment);
}
