#!/usr/bin/env bash
# The laws of the door through which files are written: links, devices, descriptors, modes, long names, full disks.
. "$SOURCE_DIR/tests/cli/common.bash"
cd "$scratch"
none_left() { [ -z "$(find . -name '.tribunal-*')" ] || { echo "temporary files are left:" >&2; find . -name '.tribunal-*' >&2; exit 1; }; }
one_line() { [ "$(wc -l <err)" -eq 1 ] || { echo "expected one line:" >&2; cat err >&2; exit 1; }; }
cases() { expect "$1" cases --count 3 --family affine "${@:2}"; }

cases 0 --out right.jsonl

# A link is followed and stays, one that leads to nothing too, and one in another folder, relative to that.
mkdir far
echo old >far/there
ln -s far/there link
cases 0 --out link
[ -L link ] && cmp right.jsonl far/there
ln -s fresh far/dangling
ln -s far/dangling twice
cases 0 --out twice
[ -L twice ] && [ -L far/dangling ] && cmp right.jsonl far/fresh
ln -s loop loop
cases 5 --out loop
one_line

# What cannot be renamed over is written to: devices, pipes, and descriptors, which go on where they stood.
for _ in 1 2; do "$TRIBUNAL" cases --count 3 --family affine --out /dev/null; done
[ -c /dev/null ]
{ echo before && "$TRIBUNAL" cases --count 3 --family affine --out /dev/stdout && echo after; } >all
[ "$(sed 1d all | head -n -1)" = "$(cat right.jsonl)" ] && [ "$(head -n 1 all)" = before ] && [ "$(tail -n 1 all)" = after ]
[ -L /dev/stdout ]
for name in /dev/fd/7 /proc/self/fd/7; do
  rm -f seventh
  { "$TRIBUNAL" cases --count 3 --family affine --out $name 7>&8; } 8>seventh
  cmp right.jsonl seventh
done
"$TRIBUNAL" cases --count 3 --family affine --out /dev/fd/1 | cmp - right.jsonl
mkfifo pipe
cat pipe >piped &
cases 0 --out pipe
wait $!
[ -p pipe ] && cmp right.jsonl piped
"$TRIBUNAL" cases --count 3 --family affine --out /dev/fd/9 >out 2>err 9>&- && status=0 || status=$?
[ "$status" -eq 5 ] && one_line
mkdir special
ln -s /dev/null special/summary.json
expect 1 fuzz --method mt-float --count 20000 --out special
[ -L special/summary.json ] && [ -s special/counterexamples.jsonl ] && [ -c /dev/null ]

# A file that was there keeps its mode and its owner; a new one obeys the umask.
for mode in 600 640 666 755; do
  echo old >mode
  chmod $mode mode
  cases 0 --out mode
  [ "$(stat -c %a mode)" = $mode ] && cmp right.jsonl mode
done
(umask 027 && cases 0 --out masked)
[ "$(stat -c %a masked)" = 640 ]
if [ "$(id -u)" -eq 0 ]; then
  echo old >owned
  chown 12345:54321 owned
  chmod 4755 owned
  cases 0 --out owned
  [ "$(stat -c %u:%g:%a owned)" = 12345:54321:4755 ] && cmp right.jsonl owned

  # As somebody else: what may not be written to is left alone, and so is the folder; a file alone in a folder where
  # nothing may be made, or of another owner, is written to in its place.
  other=(setpriv --reuid 12345 --regid 12345 --clear-groups)
  chmod 755 "$scratch"
  mkdir mine closed shared
  chown 12345:12345 mine
  chmod 777 shared
  as_other() {
    local expected=$1 status=0
    shift
    "${other[@]}" "$TRIBUNAL" cases --count 3 --family affine --out "$1" >out 2>err || status=$?
    [ "$status" -eq "$expected" ] || { echo "as another user, $1: exit $status, expected $expected" >&2; cat err >&2; exit 1; }
  }
  if "${other[@]}" "$TRIBUNAL" --version >/dev/null 2>&1; then
    echo old >mine/read_only
    chmod 444 mine/read_only
    as_other 5 mine/read_only
    [ "$(cat mine/read_only)" = old ] && one_line
    as_other 5 closed/new
    one_line
    echo old >closed/open
    chmod 666 closed/open
    as_other 0 closed/open
    cmp right.jsonl closed/open
    [ "$(stat -c %u:%a closed/open)" = 0:666 ]
    echo old >shared/of_root
    chmod 666 shared/of_root
    as_other 0 shared/of_root
    cmp right.jsonl shared/of_root
    [ "$(stat -c %u:%a shared/of_root)" = 0:666 ]
    mkdir locked
    echo '{}' >locked/cases.jsonl
    chmod 700 locked
    "${other[@]}" "$TRIBUNAL" classify --method mt-double --in locked/cases.jsonl >out 2>err && status=0 || status=$?
    [ "$status" -eq 3 ] && one_line && says err 'Permission denied'
  fi
fi

# Names as long as the system takes them, and what it does not take.
long=$(printf 'n%.0s' $(seq 250))
cases 0 --out "$long"
cmp right.jsonl "$long"
cases 0 --out "$(printf 'n%.0s' $(seq 255))"
too_long=$(printf 'n%.0s' $(seq 256))
cases 5 --out "$too_long"
one_line
for name in "$too_long" loop right.jsonl/below; do
  for command in "classify --method mt-double --in" "check --method mt-double" "replay" "render -o p.png --method mt-double" "verify" \
    "report" "leak --method mt-double" "fuzz --count 10 --method mt-double --mesh" "certify --method mt-double --out c --cases" \
    "chart --out c --scenes" "chart --redraw" "sweep --redraw" "fuzz --count 10 --method mt-double --plugin"; do
    # shellcheck disable=SC2086
    expect 3 $command "$name"
    one_line
  done
done

# A full disk, a closed pipe, a limit of sizes: exit 5, one line, nothing left, and the file that was there as it was.
expect 5 cases --count 3 --out /dev/full
one_line
says err 'No space left'
"$TRIBUNAL" methods 2>err >/dev/full && status=0 || status=$?
[ "$status" -eq 5 ] && one_line
set +o pipefail
{ "$TRIBUNAL" cases --count 20000 2>err && status=0 || status=$?; echo $status >status; } | head -n 1 >first
set -o pipefail
[ "$(cat status)" -eq 5 ] && one_line
echo old >limited
(ulimit -f 1; "$TRIBUNAL" cases --count 1000 --out limited >out 2>err) && status=0 || status=$?
[ "$status" -eq 5 ] && one_line && says err 'File too large' && [ "$(cat limited)" = old ]
mkdir findings
(ulimit -f 1; "$TRIBUNAL" fuzz --method mt-float --count 20000 --out findings >out 2>err) && status=0 || status=$?
[ "$status" -eq 5 ] && says err 'File too large' && [ -z "$(ls findings)" ]
none_left

# A directory, a folder that is not there, a file where a folder is wanted.
mkdir taken
for name in taken taken/ '' nowhere/x right.jsonl/x; do
  cases 5 --out "$name"
  one_line
done
expect 5 certify --method mt-double --out right.jsonl/x && one_line
expect 5 fuzz --method mt-double --count 10 --out right.jsonl && one_line
cmp right.jsonl link
none_left
