// What the demo found, read back from the files that its commands wrote: the page shows nothing else.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "exact/cases/case_io.h"

namespace tribunal {

/// A set that was run whole.
struct WholeSet {
  std::string name;
  std::uint64_t size, wrong;
};

/// Of the cases that were drawn in one format.
struct SampleFigures {
  std::string fmt;
  std::uint64_t sampled = 0, wrong = 0;
};

/// The figures of one certificate.json.
struct CertificateFigures {
  std::string method, verdict, worst;
  std::vector<WholeSet> whole;
  std::vector<SampleFigures> samples;
  std::uint64_t counterexamples = 0;
  std::vector<std::pair<std::string, std::size_t>> gaps{};  ///< reason, how many strata

  bool refuted() const { return verdict == "refuted"; }
};

/// One method's sum over a fuzz run's summary.json, in one format.
struct FuzzFigures {
  std::string method, fmt;
  std::uint64_t judged = 0, wrong = 0;
};

struct Place {
  int column, row;
};

/// One comparison of pictures, from its --stats file and its cases.
struct PictureFigures {
  std::string method, fmt;
  int width = 0, height = 0;
  std::uint64_t pixels = 0, other_colour = 0;
  std::vector<Place> places{};  ///< of differing pixels that have a case
};

struct Tour {
  std::string directory;  ///< as given on the command line
  std::vector<std::string> commands;
  CertificateFigures floating, exact;
  std::vector<FuzzFigures> fuzz;
  Case counterexample;  ///< the plainest one of `floating`
  std::string replay;   ///< what `replay` says of it
  std::vector<PictureFigures> pictures;
  Json chart;
  double seconds = 0;
};

CertificateFigures certificate_figures(const Json& certificate);

std::vector<FuzzFigures> fuzz_figures(const Json& summary);

/// `stats` compares the reference (first) with a method; `cases` are the differing pixels'.
PictureFigures picture_figures(const Json& stats, const std::vector<Case>& cases);

/// The counterexample that is easiest on a reader: a segment and a triangle with area, not in one plane, of
/// everyday size, if there is one; of these the one with the shortest coordinates. There is at least one case
/// with a segment.
const Case& plainest(const std::vector<Case>& cases);

}  // namespace tribunal
