#!/usr/bin/env bash
# What watches an hour of fuzz sees memory that grows, a rate that falls, a wrong answer and a test without teeth: each is
# played by a program that draws fuzz's progress.
source "$(dirname "$0")/common.bash"
cd "$scratch"
cat >player <<'EOP'
#!/usr/bin/python3
import json, os, sys, time
if sys.argv[2] == "--help":
    print("polygon-one polygon-two")
    sys.exit(0)
option = lambda name: sys.argv[sys.argv.index(name) + 1]
play, seconds, out = os.environ["PLAY"], float(option("--seconds")), option("--out")
cases, held = 0, []
while (spent := time.process_time()) < seconds:  # not of the clock: other tests may be running
    while time.process_time() - spent < (0.02 if play == "slows" and spent > 0.75 * seconds else 0.01):
        pass
    cases += 1000
    if play == "leaks":
        held.append(bytearray(1000000))
    sys.stderr.write(f"\r\x1b[K  {cases / 1e6:.6f} M cases  1 k/s")
os.makedirs(out, exist_ok=True)
wrong = {"sf-filtered": int(play == "errs"), "sf-double": int(play != "toothless")}
with open(out + "/summary.json", "w") as file:
    json.dump({"cases": cases, "families": ["one", "two"],
               "counts": [{"method": m, "wrong": w} for m, w in wrong.items()]}, file)
sys.exit(int(sum(wrong.values()) > 0) if play != "toothless" else 1)
EOP
chmod +x player
# watched CODE PLAY TEXT: the watch ends so, having said this.
watched() {
  local status=0
  PLAY=$2 python3 "$SOURCE_DIR/tests/soak/watch_fuzz.py" "$PWD/player" polygons 2 "$2" >/dev/null || status=$?
  [ "$status" -eq "$1" ] && grep -qF -- "$3" "$2.say" || { echo "$2: exit $status, expected $1 and: $3" >&2; cat "$2.say" >&2; exit 1; }
}
watched 0 flat 'cases of 2 families in 2 s; memory '
[ "$(cut -d' ' -f2 flat.count)" -eq 0 ]
watched 1 leaks 'BROKEN: memory grew'
watched 1 slows 'BROKEN: the rate fell'
watched 1 errs 'BROKEN: 1 wrong answers of sf-filtered'
watched 1 toothless 'BROKEN: sf-double was never caught'
