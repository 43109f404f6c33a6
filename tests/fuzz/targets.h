// What is fed with bytes that anybody may have written. Each target reads them as one kind of input: it must be
// accepted, and then hold what the target demands of it, or be refused by a Failure with Exit::bad_input.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "exact/base/failure.h"

namespace tribunal::fuzzing {

/// An input on which the program is wrong.
struct Violation : std::logic_error {
  using std::logic_error::logic_error;
};

inline void demand(bool holds, const std::string& what) {
  if (!holds) throw Violation(what);
}

/// Runs what may refuse its input; whether it accepted it.
template <class Work>
bool accepts(const Work& work) {
  try {
    work();
    return true;
  } catch (const Failure& failure) {
    demand(failure.exit() == Exit::bad_input,
           std::string("refused as something else than bad input: ") + failure.what());
    demand(!std::string_view(failure.what()).empty(), "refused without a word");
    return false;
  }
}

void off(std::string_view bytes);  ///< meshes
void obj(std::string_view bytes);
void ply(std::string_view bytes);
void stl(std::string_view bytes);
void cases(std::string_view bytes);       ///< a case file
void answers(std::string_view bytes);     ///< a file of answers
void scene(std::string_view bytes);       ///< without files that it names
void solid(std::string_view bytes);       ///< a solid's own file
void chain(std::string_view bytes);       ///< a log as it stands in a file
void log(std::string_view bytes);         ///< the records of a certificate's log, whose chain is made anew
void checkpoint(std::string_view bytes);  ///< the records of a checkpoint, whose chain is made anew
void query(std::string_view bytes);       ///< a probe and a target, asked of the certified test and of the reference

struct Target {
  const char* name;  ///< of the program, and of its folder in data/corpora
  void (*run)(std::string_view bytes);
};

inline constexpr Target targets[] = {
    {"off", off},     {"obj", obj},         {"ply", ply},     {"stl", stl},
    {"cases", cases}, {"answers", answers}, {"scene", scene}, {"solid", solid},
    {"chain", chain}, {"query", query},     {"log", log},     {"checkpoint", checkpoint},
};

}  // namespace tribunal::fuzzing
