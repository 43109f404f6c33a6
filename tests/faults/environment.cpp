// Preloaded, changes the floating-point environment or the locale as CHANGE_TO says, when CHANGE_WHEN says: "start"
// before main, "threads" in every new thread before it runs, a number N at the N-th malloc on the thread that calls it,
// "timer" after CHANGE_AFTER microseconds in the thread that is then interrupted. The file CHANGED is made at the first
// change.
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/time.h>
#include <ucontext.h>
#include <unistd.h>

#include <cfenv>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <locale>

extern "C" void* __libc_malloc(std::size_t);

namespace {

struct Change {
  const char* name;
  unsigned sse_off, sse_on;        // bits of MXCSR
  unsigned short x87_off, x87_on;  // bits of the x87 control word
};

constexpr Change changes[] = {
    {"ftz", 0, 0x8000, 0, 0},           {"daz", 0, 0x0040, 0, 0},       {"down", 0, 0x2000, 0, 0x0400},
    {"up", 0, 0x4000, 0, 0x0800},       {"zero", 0, 0x6000, 0, 0x0c00}, {"x87-53", 0, 0, 0x0300, 0x0200},
    {"x87-24", 0, 0, 0x0300, 0x0000},   {"x87-up", 0, 0, 0, 0x0800},    {"traps", 0x1f80, 0, 0x003f, 0},
    {"all", 0, 0xe040, 0x0300, 0x0c00},
};

const char* variable(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

const Change* wanted() {
  for (const Change& c : changes) {
    if (std::strcmp(c.name, variable("CHANGE_TO")) == 0) return &c;
  }
  return nullptr;
}

[[noreturn]] void give_up(const char* why) {
  std::fprintf(stderr, "environment.so: %s\n", why);
  _exit(98);
}

void note() {
  const int file = open(variable("CHANGED"), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (file >= 0) close(file);
}

void change_locale() {
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) give_up("no locale de_DE.UTF-8");
  if (std::strcmp(variable("CHANGE_TO"), "c++locale") == 0) std::locale::global(std::locale("de_DE.UTF-8"));
}

void change() {
  note();
  if (const Change* const c = wanted()) {
    unsigned short x87;
    __asm__ volatile("fnstcw %0" : "=m"(x87));
    x87 = static_cast<unsigned short>((x87 & ~c->x87_off) | c->x87_on);
    unsigned sse = (__builtin_ia32_stmxcsr() & ~c->sse_off & ~0x3fU) | c->sse_on;
    __asm__ volatile("fnclex; fldcw %0" : : "m"(x87));
    __builtin_ia32_ldmxcsr(sse);
  } else {
    change_locale();
  }
}

// A signal's handler returns to the environment that was interrupted, which is therefore changed in what was saved.
void on_timer(int, siginfo_t*, void* context) {
  const Change* const c = wanted();
  auto* const saved = static_cast<ucontext_t*>(context)->uc_mcontext.fpregs;
  if (c == nullptr || saved == nullptr) _exit(98);
  note();
  saved->mxcsr = (saved->mxcsr & ~c->sse_off & ~0x3fU) | c->sse_on;
  saved->cwd = static_cast<unsigned short>((saved->cwd & ~c->x87_off) | c->x87_on);
  saved->swd = 0;
}

void start_timer() {
  struct sigaction action {};
  action.sa_sigaction = on_timer;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  sigaction(SIGALRM, &action, nullptr);
  itimerval after{};
  after.it_value.tv_usec = std::atol(variable("CHANGE_AFTER"));
  setitimer(ITIMER_REAL, &after, nullptr);
}

long change_at = 0, calls = 0;

__attribute__((constructor)) void at_start() {
  unsetenv("LD_PRELOAD");  // Python, which draws figures, is not on trial
  const char* const when = variable("CHANGE_WHEN");
  if (std::strcmp(when, "start") == 0) change();
  if (std::strcmp(when, "timer") == 0) start_timer();
  __atomic_store_n(&change_at, std::atol(when), __ATOMIC_RELAXED);
}

struct Start {
  void* (*run)(void*);
  void* with;
};

void* changed_run(void* p) {
  const Start start = *static_cast<Start*>(p);
  std::free(p);
  change();
  return start.run(start.with);
}

using Create = int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);

}  // namespace

extern "C" void* malloc(std::size_t size) noexcept {
  const long at = __atomic_load_n(&change_at, __ATOMIC_RELAXED);
  if (at > 0 && __atomic_add_fetch(&calls, 1, __ATOMIC_RELAXED) == at) change();
  return __libc_malloc(size);
}

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                              void* with) noexcept {
  static Create* const real = reinterpret_cast<Create*>(dlsym(RTLD_NEXT, "pthread_create"));
  if (std::strcmp(variable("CHANGE_WHEN"), "threads") != 0) return real(thread, attributes, run, with);
  auto* const start = static_cast<Start*>(__libc_malloc(sizeof(Start)));
  *start = {run, with};
  return real(thread, attributes, changed_run, start);
}
