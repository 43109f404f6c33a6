#!/usr/bin/env bash
# Cases with rings, alone and among triangles: classify, replay, shrink, and what bad input is told.
source "$(dirname "$0")/common.bash"
cd "$scratch"

frame='[[[0,0,0],[9,0,0],[9,9,0],[0,9,0]],[[4,4,0],[6,4,0],[6,6,0],[4,6,0]]]'
cat >cases.jsonl <<EOF
{"id":"in the hole","seg":[[5,5,1],[5,5,-1]],"rings":$frame,"expect":0}
{"id":"a triangle","seg":[[0,0,1],[0,0,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]],"expect":1}
{"id":"at the hole","ray":{"o":[5,4,1],"d":[0,0,-1]},"rings":$frame,"expect":1}
{"id":"not planar","seg":[[1,2,5],[1,2,-5]],"rings":[[[0,0,0],[9,0,1],[9,9,0],[0,9,1]]],"expect":1}
{"id":"in the plane","fmt":"binary32","seg":[[1,1,0],[2,1,0]],"rings":$frame,"expect":1}
{"id":"in the plane, over an edge","seg":[[1,1,0],[12,1,0]],"rings":$frame,"expect":1}
{"id":"two points","seg":[[1,0,1],[1,0,-1]],"rings":[[[0,0,0],[2,0,0]]],"expect":1}
EOF
expect 0 classify --method sf-epick,haines-double --in cases.jsonl
diff out - <<'EOF'
{"id":"in the hole","method":"sf-epick","hit":0,"status":"ok","contact":"none","planar":true}
{"id":"in the hole","method":"haines-double","hit":0,"status":"ok","contact":"none"}
{"id":"a triangle","method":"sf-epick","hit":1,"status":"ok","class":"C017","contact":"vertex","at":"between","side":"front"}
{"id":"a triangle","method":"haines-double","status":"unsupported"}
{"id":"at the hole","method":"sf-epick","hit":1,"status":"ok","contact":"edge","at":"between","planar":true}
{"id":"at the hole","method":"haines-double","status":"unsupported"}
{"id":"not planar","method":"sf-epick","hit":1,"status":"ok","contact":"interior","at":"between","planar":false}
{"id":"not planar","method":"haines-double","status":"unsupported"}
{"id":"in the plane","method":"sf-epick","hit":1,"status":"ok","contact":"coplanar","planar":true}
{"id":"in the plane","method":"haines-double","hit":0,"status":"ok","contact":"none"}
{"id":"in the plane, over an edge","method":"sf-epick","hit":1,"status":"ok","contact":"coplanar","planar":true}
{"id":"in the plane, over an edge","method":"haines-double","status":"unsupported"}
{"id":"two points","method":"sf-epick","hit":1,"status":"ok","contact":"coplanar","planar":true}
{"id":"two points","method":"haines-double","status":"unsupported"}
EOF
expect 0 replay cases.jsonl && says out 'not judged: outside its contract' && says out 'hit (interior), not planar'

# feito-double reports a hit just outside. The second ring and the repeated vertex have nothing to do with it.
cat >wrong.jsonl <<'EOF'
{"id":"wrong","seg":[["0x1.ad513304516p-3","-0x1.a2366cff18e71p+0","0x1.987827beb956p-5"],["0x1.decdaee5b4becp-1","0x0p+0","0x1.3ceba11c06ec8p-3"]],"rings":[[["0x1.2510fdd3648b8p-1","-0x1.a2366cff18e71p-1","0x1.a309ab0bb542p-4"],["-0x1.5p-3","0x1.6p-2","0x1p+0"],["0x0p+0","0x1.74p-2","0x1.2p+1"],["0x0p+0","0x1.74p-2","0x1.2p+1"]],[["0x0p+0","0x1.74p-2","0x1.2p+1"]]],"expect":0}
EOF
expect 1 replay wrong.jsonl && says out WRONG
expect 0 shrink --method feito-double --out small.jsonl wrong.jsonl
expect 1 replay small.jsonl && says out WRONG
lacks out hole
expect 0 shrink --method feito-double --out smaller.jsonl small.jsonl
cmp small.jsonl smaller.jsonl
expect 3 shrink --method sf-epick wrong.jsonl && says err 'answers it rightly'

bad() { echo "$1" >bad.jsonl; expect 3 classify --method sf-double --in bad.jsonl && says err "$2"; }
bad '{"id":"x","seg":[[0,0,1],[0,0,-1]],"rings":[]}' 'bad.jsonl:1: rings: expected an array of at least one ring'
bad '{"id":"x","seg":[[0,0,1],[0,0,-1]],"rings":[[]]}' 'rings[0]: expected an array of at least one point'
bad '{"id":"x","seg":[[0,0,1],[0,0,-1]],"rings":[[[0,0]]]}' 'rings[0][0]'
echo '{"id":"x","seg":[[0,0,1],[0,0,-1]],"rings":[[[0,0,1e999]]]}' >far.jsonl
expect 0 classify --method sf-double --in far.jsonl && says out '"status":"nonfinite"'
bad '{"id":"x","seg":[[0,0,1],[0,0,-1]],"rings":[[[0,0,0]]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}' 'found both'
bad '{"id":"x","seg":[[0,0,1],[0,0,-1]],"rings":[[[0,0,0]]],"class":"C017"}' 'has no class'
bad '{"id":"x","fmt":"binary32","seg":[[0,0,1],[0,0,-1]],"rings":[[[0,0,0.1]]]}' 'rings[0][0]'
bad '{"id":"x","seg":[[0,0,1],[0,0,-1]],"ring":[[[0,0,0]]]}' 'did you mean "rings"?'
expect 3 certify --method sf-double --cases cases.jsonl --budget quick --out certificate && says err 'expected "tri", or --polygons'
