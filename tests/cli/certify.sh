#!/usr/bin/env bash
# Certificates from end to end: written, verified, tampered with, on a mesh of the user's own.
source "$(dirname "$0")/common.bash"
cd "$scratch"

expect 0 certify --method sf-epick --budget quick --threads 1 --out one
says out 'sf-epick: not refuted' && says out "binary64 163/163, ray classes 165/165, binary32 163/163, ray classes 165/165" && says one/certificate.md '## Proved'
expect 0 verify one && says out 'verified: sf-epick not refuted' && says out 'asked again'

cp -r one edited
sed -i '0,/"counts":{"C001":\[/s//&1/' edited/log.jsonl
expect 3 verify edited && says err 'edited/log.jsonl:' && says err 'was changed'
cp one/log.jsonl edited/log.jsonl
sed -i '0,/"wrong": 0/s//"wrong": 1/' edited/certificate.json
expect 1 verify edited && says out 'certificate.json is not what the log gives'
head -n -1 one/log.jsonl >edited/log.jsonl
expect 3 verify edited && says err 'cut short'
expect 3 verify nowhere

mesh=$SOURCE_DIR/data/meshes/pig.off
expect 1 certify --method sf-float --mesh "$mesh" --out mesh --threads 2
says mesh/certificate.md 'your mesh' && says mesh/counterexamples.jsonl '"method":"sf-float"'
expect 0 verify mesh
expect 3 certify --method sf-float --mesh nothing.off --out mesh2 && [ ! -e mesh2 ]
expect 2 certify --method sf-float --budget large --out x
