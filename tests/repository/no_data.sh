#!/usr/bin/env bash
# A test that is given no data fails: those that read data/ are run in a folder where data/ holds nothing. The table names,
# for every test file that reads data/, a test that must fail there; a file that is not in it is an error.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

table="
exact/mesh/second_opinion_test.cpp SecondOpinion.OnTheMeshesAsTheyAre SecondOpinion.OnTheMeshesInOtherForms
exact/wild_cases_test.cpp WildCases.*
exact/outcome_test.cpp Causes.WitnessesOfPublishedFailuresAreLogic
exact/rivals_test.cpp Rivals.AreWrongOnTheirWitnesses
exact/severity_test.cpp Plain.NoSoundTestIsWrongThereOnAMesh Plain.PublishedFailuresAre
exact/case_files_test.cpp CaseFiles.*
exact/scan_test.cpp CaseScan.ReadsTheCorporaAsTheLibraryDoes
tracer/render_test.cpp Compare.CasesShowTheDifference Render.ExactMethodsLeaveNoCracks
tracer/framed_test.cpp FramedScene.*
tracer/departure_test.cpp Departures.AreProvedAtVerticesEdgesAndFaces Departures.AreCustomaryForInexactMethods
tracer/chart_parts_test.cpp Leaks.AreThoseOfTheTrial
tracer/scenes_test.cpp ShippedScenes.*
tracer/watertight_test.cpp Watertight.*
tracer/parity_test.cpp */ParityOf.EveryRayIsTheWindingNumber/*
tracer/polygon_scenes_test.cpp Polygons.* Solids.AreClosedAndAsDescribed
tracer/scene_test.cpp ReadScene.ShippedScenesLoad
tracer/tree_test.cpp BoxedFaces.LanesLeavePolygonsToTheMethod
tracer/packet_test.cpp */Packets.SeePolygonsAsBruteForceDoes/* */Packets.GeneralPositionIsTheLanes/*
"
# Not to be opened: a name for a place in a text.
named_only='exact/topology_test.cpp'

mkdir -p "$scratch"/data/{cases,scenes,meshes,solids}
cd "$scratch"
bad=0
while read -r file tests; do
  [ -n "$file" ] || continue
  [ -f "$SOURCE_DIR/tests/$file" ] || { echo "$file: in the table, but not there" >&2; bad=1; continue; }
  program=$BUILD_DIR/tests/${file%%/*}_tests
  set -f
  for filter in $tests; do
    names=$("$program" --gtest_list_tests --gtest_filter="$filter" | awk '/^[^ ].*\.( |$)/ { suite = $1 } /^  / { print suite $1 }')
    [ -n "$names" ] || { echo "$file: $filter: no such test" >&2; bad=1; }
    for name in $names; do
      ! "$program" --gtest_filter="$name" >out 2>&1 || { echo "$file: $name passes without data" >&2; bad=1; }
    done
  done
  set +f
done <<<"$table"

for file in $(cd "$SOURCE_DIR/tests" && grep -rlE '"data/(cases|scenes|meshes|solids)' exact tracer core | sort); do
  case " $named_only " in *" $file "*) continue ;; esac
  grep -q "^$file " <<<"$table" || { echo "$file reads data/ and is not in the table of tests/repository/no_data.sh" >&2; bad=1; }
done
exit $bad
