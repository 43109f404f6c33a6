// The command table.
#include "exact/cli/program.h"
#include "tracer/cli/command.h"

int main(int argc, char** argv) {
  using namespace tribunal;
  constexpr Command commands[] = {
      {"methods", "list the methods on trial", "tribunal methods", declare_methods},
      {"classify", "answer every case of a file by one or more methods",
       "tribunal classify --method sf-rational,sf-double --in cases.jsonl --out answers.jsonl", declare_classify},
      {"fuzz", "hunt for inputs on which a method parts from the exact answer",
       "tribunal fuzz --method sf-double,mt-float --seed 1 --count 1000000 --out findings", declare_fuzz},
      {"cases", "write generated cases to a file, for a test of your own to answer",
       "tribunal cases --family affine,ulp --fmt binary64 --count 10000 --out cases.jsonl", declare_cases},
      {"judge", "judge answers that were computed elsewhere",
       "tribunal judge --cases cases.jsonl --answers answers.jsonl --out judged", declare_judge},
      {"check", "hold a method against what a case file expects",
       "tribunal check cases.jsonl --method sf-double --exact", declare_check},
      {"shrink", "make a counterexample minimal", "tribunal shrink findings/counterexamples.jsonl", declare_shrink},
      {"replay", "show the exact signs of a case and every method's answer to it",
       "tribunal replay findings/counterexamples.jsonl", declare_replay},
      {"certify", "say with evidence how far a method can be trusted",
       "tribunal certify --method sf-double --budget quick --out certificate", declare_certify},
      {"verify", "make a certificate again from its log and hold it against what was written",
       "tribunal verify certificate", declare_verify},
      {"leak", "is a test watertight? Rays at every vertex, edge and face of a mesh",
       "tribunal leak mesh.off --method sf-double,mt-double,woop-double --out leaks", declare_leak},
      {"render", "ray trace a scene with a method",
       "tribunal render data/scenes/elephant.json --method sf-double --against sf-rational -o image.png",
       declare_render},
      {"sweep", "where does each method begin to fail? Outcomes along stress axes",
       "tribunal sweep --method sf-double,mt-double --axis scale,sliver --out sweep", declare_sweep},
      {"chart", "measure speed and accuracy on the same cases", "tribunal chart --out charts", declare_chart},
      {"report", "one page to explore any results: of fuzz, certify, judge, sweep, chart, leak, render, bench",
       "tribunal report findings certificate sweep --out report.html", declare_report},
      {"demo", "the whole tour: fuzz, certify, sweep, render, chart, and report, a page that shows it",
       "tribunal demo --out out", declare_demo},
  };
  return run_program(commands, argc, argv);
}
