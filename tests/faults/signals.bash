# Sourced by scripts that have sourced tests/cli/common.bash.
tried=0

none_left() { [ -z "$(find . -name '.tribunal-*')" ] || { echo "temporary files are left:" >&2; find . -name '.tribunal-*' >&2; exit 1; }; }

# code_of SIGNAL: the exit code that says so.
code_of() { case $1 in INT) echo 130 ;; TERM) echo 143 ;; HUP) echo 129 ;; esac; }

# wait_until CONDITION: for a minute at most.
wait_until() {
  local i
  for ((i = 0; i < 3000; ++i)); do
    eval "$1" && return 0
    sleep 0.02
  done
  echo "never: $1" >&2
  exit 1
}

# files_of DIR: which files it holds, and what is in them.
files_of() { (cd "$1" && find . -type f | LC_ALL=C sort | xargs -r sha256sum); }

# send_at_moments N ARG…: runs the command, which writes to out/, once to its end, and then N times with a signal at a
# moment of that time. It ends within two seconds with the signal's exit code and one line, or was done before; out/ holds
# what it held before, or all.
send_at_moments() {
  local moments=$1 i signal status usual=0 start took late
  shift
  rm -rf out && mkdir out
  start=$EPOCHREALTIME
  "$TRIBUNAL" "$@" >said 2>err || usual=$?
  took=$(bc -l <<<"$EPOCHREALTIME - $start")
  [ "$usual" -le 1 ] || { echo "$*: exit $usual without a signal" >&2; cat err >&2; exit 1; }
  [ -n "$(ls out)" ]
  for ((i = 0; i < moments; ++i)); do
    signal=$([ $((i % 2)) -eq 0 ] && echo TERM || echo INT)
    rm -rf again && mkdir again && echo old >again/mine
    "$TRIBUNAL" "${@/#out/again}" >said 2>err & pid=$!
    sleep "$(bc -l <<<"$took * ($i + 0.5) / $moments")"
    kill -$signal $pid 2>/dev/null || true
    start=$EPOCHREALTIME
    status=0
    wait $pid || status=$?
    late=$(bc -l <<<"$EPOCHREALTIME - $start")
    tried=$((tried + 1))
    none_left
    rm again/mine
    if [ "$status" -eq "$(code_of $signal)" ]; then
      [ "$(bc -l <<<"$late < 2")" -eq 1 ] || { echo "$*: ended $late s after SIG$signal" >&2; exit 1; }
      [ "$(wc -l <err)" -eq 1 ] || grep -q INTERRUPTED said || { echo "$*: SIG$signal, and not one line" >&2; cat err >&2; exit 1; }
    elif [ "$status" -ne "$usual" ]; then
      echo "$*: exit $status after SIG$signal" >&2
      cat err >&2
      exit 1
    fi
    [ -z "$(ls again)" ] || [ "$(ls again)" = "$(ls out)" ] || may_hold again || { echo "$*: SIG$signal left a part:" >&2; ls again >&2; exit 1; }
  done
  rm -rf out again
  echo "$1: $moments moments of ${took:0:4} s"
}
# may_hold DIR: a sound state between nothing and all; scripts define it anew.
may_hold() { [ -e "$1/checkpoint.jsonl" ] && [ "$(ls "$1")" = checkpoint.jsonl ] || [ -e "$1/sweep.json" ] && [ ! -e "$1/thresholds.svg" ]; }
