#include "exact/compilers/compare.h"

#include <algorithm>
#include <cstdio>

#include "exact/base/failure.h"
#include "exact/base/interrupt.h"
#include "exact/base/json.h"
#include "exact/base/parallel.h"
#include "exact/cases/case_io.h"
#include "exact/cases/case_line.h"
#include "exact/cases/family_table.h"
#include "exact/certificate/rate.h"
#include "exact/methods/methods.h"
#include "exact/record/environment.h"
#include "exact/trial/judge.h"
#include "exact/trial/quick_truth.h"
#include "exact/trial/severity.h"

namespace tribunal {
namespace {

constexpr std::uint64_t block_size = 256;
constexpr Format formats[] = {Format::binary32, Format::binary64};

/// A method in the program's own build and in all others.
struct Compared {
  const Method* own;
  std::vector<const Method*> builds;
};

const Method& in_build(const Build& build, const std::string& name) {
  for (const Method& m : build.methods) {
    if (m.name == name) return m;
  }
  throw Failure(Exit::usage, name + " is not among the methods that are compiled again");
}

std::vector<Compared> compared(const ComparePlan& plan) {
  std::vector<Compared> all;
  for (const std::string& name : plan.methods) {
    Compared c{find_method(name), {}};
    for (const Build& build : plan.builds) c.builds.push_back(&in_build(build, name));
    all.push_back(std::move(c));
  }
  return all;
}

/// A row for every method × build, all empty.
std::vector<BuildRow> empty_rows(const ComparePlan& plan, const std::vector<Compared>& methods) {
  std::vector<BuildRow> rows;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    for (std::size_t b = 0; b < plan.builds.size(); ++b) {
      rows.push_back({.method = m, .build = b, .format = methods[m].own->contract.format, .count = {}});
    }
  }
  return rows;
}

void compare(const Trial& trial, const Truth& truth, const Compared& c, std::span<BuildRow> rows) {
  const Answer own_answer = c.own->ask(trial.query);
  const Outcome own = judge(*c.own, truth, own_answer);
  for (std::size_t b = 0; b < rows.size(); ++b) {
    BuildRow& row = rows[b];
    const Answer answer = c.builds[b]->ask(trial.query);
    const Outcome outcome = judge(*c.builds[b], truth, answer);
    row.count.add(outcome, Stage::none);
    if (is_wrong(outcome)) row.count.add_wrong(severity_of(trial.query, truth), Cause::unknown);
    if (answer.hit == own_answer.hit) continue;
    ++row.changed;
    row.spoiled += is_wrong(outcome) && !is_wrong(own);
    row.mended += !is_wrong(outcome) && is_wrong(own);
    if (!row.witness) row.witness = trial;
  }
}

/// Case k of a format: of all families in turn. Bounds on t are left away, since builds take none.
Trial trial_of(const ComparePlan& plan, Format format, std::uint64_t k) {
  const std::span<const Family> families = families_of(Operands::triangles);
  Trial trial = families[k % families.size()].make(format, plan.seed, k / families.size());
  trial.query.bounds.reset();
  return trial;
}

std::vector<BuildRow> run_block(const ComparePlan& plan, const std::vector<Compared>& methods, Format format,
                                std::uint64_t first) {
  std::vector<BuildRow> rows = empty_rows(plan, methods);
  for (std::uint64_t k = first; k < std::min(first + block_size, plan.cases); ++k) {
    const Trial trial = trial_of(plan, format, k);
    const Truth truth = quick_truth_with_facing(trial, certified_class);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (methods[m].own->contract.format != format) continue;
      compare(trial, truth, methods[m], std::span(rows).subspan(m * plan.builds.size(), plan.builds.size()));
    }
  }
  return rows;
}

void merge(std::vector<BuildRow>& sum, const std::vector<BuildRow>& block) {
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i].count += block[i].count;
    sum[i].changed += block[i].changed;
    sum[i].spoiled += block[i].spoiled;
    sum[i].mended += block[i].mended;
    if (!sum[i].witness) sum[i].witness = block[i].witness;
  }
}

}  // namespace

std::vector<BuildRow> compare_builds(const ComparePlan& plan) {
  const std::vector<Compared> methods = compared(plan);
  std::vector<BuildRow> sum = empty_rows(plan, methods);
  const std::uint64_t blocks = (plan.cases + block_size - 1) / block_size;
  for (const Format format : formats) {
    std::vector<std::vector<BuildRow>> done(blocks);
    run_blocks(blocks, plan.threads, [&](std::size_t block, unsigned) {
      done[block] = run_block(plan, methods, format, block * block_size);
    });
    if (interrupted() != 0) throw Failure(static_cast<Exit>(128 + interrupted()), "interrupted; nothing written");
    for (const std::vector<BuildRow>& rows : done) merge(sum, rows);
  }
  return sum;
}

Json to_json(const ComparePlan& plan, const std::vector<BuildRow>& rows) {
  Json builds = Json::array(), table = Json::array();
  for (const Build& b : plan.builds) builds.push_back({{"name", b.name}, {"compiler", b.compiler}, {"flags", b.flags}});
  for (const BuildRow& r : rows) {
    Json row = {{"method", plan.methods[r.method]},
                {"build", plan.builds[r.build].name},
                {"fmt", name_of(r.format)},
                {"answers", to_json(r.count)},
                {"changed", r.changed},
                {"spoiled", r.spoiled},
                {"mended", r.mended}};
    if (r.witness) row["witness"] = from_case({.id = plan.methods[r.method], .query = r.witness->query});
    table.push_back(row);
  }
  return {{"axis", "compiler"}, {"seed", plan.seed}, {"cases_of_each_format", plan.cases},
          {"builds", builds},   {"rows", table},     {"environment", environment()}};
}

std::string to_table(const ComparePlan& plan, const std::vector<BuildRow>& rows) {
  constexpr int width = 22;
  char cell[64];
  std::string text =
      "answers that are not those of the program's own build, and of these: wrong only there, wrong only in the own "
      "one\n"
      "cases of all families, most of them degenerate: what changes is what rounding decides\n\n";
  for (const Build& b : plan.builds) text += b.name + ": " + b.compiler + ", " + b.flags + "\n";
  std::snprintf(cell, sizeof cell, "\n%-22s", "method");
  text += cell;
  for (const Build& b : plan.builds) {
    std::snprintf(cell, sizeof cell, " %*s", width, b.name.c_str());
    text += cell;
  }
  for (const BuildRow& r : rows) {
    if (r.build == 0) {
      std::snprintf(cell, sizeof cell, "\n%-22s", plan.methods[r.method].c_str());
      text += cell;
    }
    std::string figure = "0";
    if (r.changed > 0) {
      const auto percent = [&](std::uint64_t n) {
        return 100 * static_cast<double>(n) / static_cast<double>(r.count.asked);
      };
      std::snprintf(cell, sizeof cell, "%.2f %% (%.2f, %.2f)", percent(r.changed), percent(r.spoiled),
                    percent(r.mended));
      figure = cell;
    }
    std::snprintf(cell, sizeof cell, " %*s", width, figure.c_str());
    text += cell;
  }
  return text + "\n";
}

}  // namespace tribunal
