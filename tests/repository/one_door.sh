#!/usr/bin/env bash
# one_door.sh ROOT: files are written, renamed and removed through exact/base/output.h, and asked about through
# exact/base/files.h, alone. Prints every breach as file:line:text.
set -euo pipefail
cd "$1"
breaches=0

# breach WHY: reports the lines on standard input, if any.
breach() {
  local lines
  lines=$(cat)
  [ -n "$lines" ] || return 0
  printf '%s:\n%s\n' "$1" "$lines" >&2
  breaches=$((breaches + 1))
}

# code PATTERN: the lines of sources that match, but for comments and the files that make the doors.
code() {
  grep -rnE --include='*.h' --include='*.cpp' "$1" core exact tracer main.cpp |
    grep -vE '^exact/base/(output|files|lines|temporaries)\.(h|cpp):' | grep -vE '^[^:]*:[0-9]+:[[:space:]]*//' || true
}

# except PATTERN: drops the lines of these files.
except() { grep -vE "^($1):" || true; }

breach 'streams and descriptors are opened by the doors: exact/base/output.h, exact/base/files.h' < <(code \
  '\b(o?fstream|ifstream|basic_[io]?fstream|f?reopen|fopen|fopen64|fdopen|tmpfile|mkstemp|mkdtemp|creat|open64|openat)\b|(^|[^_[:alnum:].>])(::)?open\(' |
  grep -vE '\bopen\("/dev/null", O_RDONLY' | except 'exact/base/spool\.cpp')  # without a name
breach 'files are renamed and removed by exact/base/output.h' < <(code \
  '\b(renameat2?|unlink|unlinkat|rmdir|linkat|symlink|truncate|ftruncate|mkdir|mkdirat|chmod|fchmod|chown|fchown)\(|\b(std::|::)(rename|remove)\("|\bstd::(rename|remove)\([^)]*(c_str|path|file|name)' |
  except 'exact/base/spool\.cpp')
breach 'the file system is asked by exact/base/files.h, which turns a refusal into bad input; elsewhere names alone' < <(code \
  '\b(std::filesystem|fs)::[a-z_]+' | grep -E '(std::filesystem|fs)::([^p]|p[^a])' || true)
breach 'handlers of signals are set by exact/base/interrupt.cpp, and of what ends the program by sudden_end.cpp' < <(code '\bsigaction\(|\bstd::signal\((SIGINT|SIGTERM|SIGHUP)|\bsigwait' |
  except 'exact/base/(interrupt|sudden_end)\.cpp')

[ "$breaches" -eq 0 ]
