# Sourced by scripts that have sourced tests/cli/common.bash: every call of a small run that touches a file fails once.
# After each the exit code tells, one line says why, no temporary file is left, and what the command writes is as it was
# before or as a run without faults leaves it. Success is one of may_be_ignored.
${CC:-cc} -std=gnu11 -Wall -Wextra -Werror -O1 -shared -fPIC -o "$scratch/failing_calls.so" "$SOURCE_DIR/tests/faults/failing_calls.c" -ldl
tried=0 broken=0

# python: stands for python3 where figures are drawn, which takes it seconds.
cat >"$scratch/python" <<'SCRIPT'
#!/bin/sh
printf '<svg/>' >"$3/thresholds.svg" && printf '<svg/>' >"$3/speed-accuracy.svg" && echo 'drawn speed-accuracy'
SCRIPT
chmod +x "$scratch/python"

# tree DIR: names and contents of all files, without what differs from run to run.
tree() {
  [ -d "$1" ] || { echo none; return 0; }
  (cd "$1" && find . -type f | LC_ALL=C sort | while read -r f; do
    echo "$f $(sed -E '/"(seconds|rays_per_second|speedup)"/d' "$f" | sha256sum)"
  done)
}

# broke WHAT: a line for people; the loop goes on.
broke() {
  echo "call $n ($(head -c 200 mark)) with $error_name: $*" >&2
  cat err >&2
  broken=$((broken + 1))
}

# as_before_or_after: what the command should leave. `between`, a function, may know of other sound states.
as_before_or_after() {
  local now
  now=$(tree out)
  if [ "$now" = "$before" ] || [ "$now" = "$after" ]; then return 0; fi
  if [ -z "$now" ] && [ "$before" = none ]; then return 0; fi
  between
}
between() { false; }

# may_be_ignored: whether a run may succeed although this call failed, since nothing that it promises rests on the call: a
# file that was only read is closed, or one without a name, which nobody will read; nothing waits to be flushed; the scratch
# directory of a drawing is removed, which is tried twice; a write takes a part, and the rest is written after it. Where the
# system refuses (EACCES), the door has another way: a file is not renamed but copied.
may_be_ignored() {
  case "$error_name $(cut -d' ' -f2- mark)" in
    *' close reading '* | *' close unnamed' | *' fflush nothing' | *' openat '*.tribunal-*-figures-*.tmp | 'short write '*) ;;
    'EACCES renameat '* | 'EACCES openat '*.tribunal-*.tmp) ;;
    *) return 1 ;;
  esac
}

# fail_each ERRNO NAME BEFORE ARG…: runs the command, which writes to out/, with the n-th call failing, for n = 1, 2, …
# until there is no n-th call. out/ is a copy of BEFORE each time; "none": it is not there.
fail_each() {
  local error=$1 error_name=$2 start=$3 status usual=0 n before after
  shift 3
  fresh() { rm -rf out && { [ "$start" = none ] || cp -r "$start" out; }; }
  run() {  # N ARG…
    local at=$1
    shift
    FAIL_AT=$at FAIL_ERRNO=$error FAIL_MARK=mark FAIL_SKIP=/proc/:/sys/:/etc/:/usr/ FAIL_PYTHON=$scratch/python \
      LD_PRELOAD=$scratch/failing_calls.so "$TRIBUNAL" "$@" >said 2>err
  }
  fresh
  before=$(tree out)
  run 0 "$@" || usual=$?
  [ "$usual" -le 1 ] || { echo "$*: exit $usual without a fault" >&2; cat err >&2; exit 1; }
  after=$(tree out)
  [ "$before" != "$after" ] || { echo "$*: writes nothing new to out/" >&2; exit 1; }
  for ((n = 1;; ++n)); do
    fresh
    rm -f mark
    status=0
    run "$n" "$@" || status=$?
    [ -e mark ] || break
    tried=$((tried + 1))
    case $status in
      "$usual")
        may_be_ignored || broke "success, as if nothing had failed"
        [ "$(tree out)" = "$after" ] || broke "success, and not what it should be" ;;
      3 | 5 | 7)
        [ "$(wc -l <err)" -eq 1 ] || broke "exit $status, and not one line"
        as_before_or_after || { broke "exit $status, and out/ is neither as before nor complete"; diff <(echo "$before") <(tree out) >&2 || true; } ;;
      *) broke "exit $status" ;;
    esac
    [ -z "$(find . -name '.tribunal-*')" ] || { broke "a temporary file is left"; find . -name '.tribunal-*' -delete; }
  done
  [ "$n" -gt 1 ] || { echo "$*: no call to fail" >&2; exit 1; }
  echo "$1 $error_name from $start: $((n - 1)) calls"
}
