// tribunal_planted: the commands that put methods on trial, with the planted bugs among the methods.
#include "exact/cli/program.h"
#include "exact/methods/methods.h"
#include "tests/planted/bugs.h"
#include "tracer/cli/command.h"

int main(int argc, char** argv) {
  using namespace tribunal;
  for (const Method& m : planted::bugs()) add_method(m);
  for (const Method& m : planted::sound_twins()) add_method(m);
  for (const Method& m : planted::polygon_bugs()) add_method(m);
  for (const Method& m : planted::sound_polygons()) add_method(m);
  add_method(planted::environment_bug());
  constexpr Command commands[] = {
      {"methods", "list the methods, planted ones too", "tribunal_planted methods", declare_methods},
      {"classify", "answer every case of a file", "tribunal_planted classify --method planted-xy --in cases.jsonl",
       declare_classify},
      {"fuzz", "hunt for inputs on which a method is wrong",
       "tribunal_planted fuzz --method planted-jimenez-w0,sound-jimenez --seconds 60", declare_fuzz},
      {"replay", "show the exact signs of a case", "tribunal_planted replay counterexamples.jsonl", declare_replay},
      {"certify", "say with evidence how far a method can be trusted",
       "tribunal_planted certify --method planted-filter-16 --out certificate", declare_certify},
  };
  return run_program(commands, argc, argv);
}
