#!/usr/bin/env bash
# Reports of real runs, one of them with hostile names, are opened and used in a headless browser.
source "$(dirname "$0")/../cli/common.bash"
cd "$scratch"
mkdir -p runs/render
any() { "$TRIBUNAL" "$@" >log 2>&1 || [ $? -eq 1 ] || { cat log >&2; exit 1; }; }

any fuzz --method sf-double,mt-double,mt-float,sf-filtered --count 10000 --out runs/fuzz
any fuzz --family polygon-affine,polygon-ulp --method haines-double,feito-double --count 3000 --out runs/polygons
any cases --count 3000 --out cases.jsonl
any classify --method sf-double --in cases.jsonl --out answers.jsonl
any judge --cases cases.jsonl --answers answers.jsonl --out runs/certificate
any sweep --method sf-double,mt-double,sf-filtered --axis scale,sliver --count 120 --out runs/sweep
any sweep --map edge --map-size 48 --method sf-double,mt-double,sf-filtered,sf-float --out runs/map
any chart --method sf-double,mt-double,sf-filtered --count 1000 --repetitions 9 --out runs/chart
any leak "$SOURCE_DIR/data/meshes/elephant.off" --method mt-float,sf-filtered,woop-double,feito-double --rays 3000 --out runs/leak
plugin mine "$SOURCE_DIR/docs/examples/moeller_trumbore.c"
any fuzz --plugin ./mine.so --method my-mt --count 3000 --out runs/mine
any render "$SOURCE_DIR/data/scenes/elephant.json" --size 160x120 --method mt-float --against sf-filtered -o runs/render/elephant.png
any report runs --out report.html

# Ids and folders are anything; names of methods have a rule of their own (shown.h).
hostile='<img src=x onerror=alert(1)></script><script>alert(2)</script>'
directory='<b onclick=alert(3)>&amp;"'"'"
python3 - "$hostile" <<'EOF'
import json, sys
name = sys.argv[1]
with open('cases.jsonl', 'w') as cases, open('answers.jsonl', 'w') as answers:
    for i, z in enumerate([1, -1, 2]):
        identity = f'{name}{i} "*/ \u2028'
        cases.write(json.dumps({'id': identity, 'seg': [[0.25, 0.25, 1], [0.25, 0.25, z]], 'tri': [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}) + '\n')
        answers.write(json.dumps({'id': identity, 'method': 'theirs', 'hit': 1}) + '\n')
EOF
any judge --cases cases.jsonl --answers answers.jsonl --out "$directory"
any report "$directory" --out hostile.html

python=python3
"$python" -c 'import selenium' 2>/dev/null || python=/usr/bin/python3  # where another Python hides Debian's
PATH=$(dirname "$TRIBUNAL"):$PATH "$python" "$SOURCE_DIR/tests/report/browser_test.py" report.html hostile.html
