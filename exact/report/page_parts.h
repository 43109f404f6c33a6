// Parts of the page that put a case or a chart into words.
#pragma once

#include <string>

#include "exact/cases/case_io.h"

namespace tribunal {

/// What is asked, what is right and what the method said. The case is a counterexample with a segment.
std::string answers_in_words(const Case& c);

/// The five points: shortest decimals that give them back, and hex floats.
std::string coordinates_table(const Case& c);

/// How the test of Segura and Feito decides by five signs, and whether double precision gets them right here.
std::string rule_in_words(const Case& c);

/// The five signs, exact and as double precision has them, each with what the exact one says.
std::string signs_table(const Case& c);

/// How many times longer an exact answer takes, from a chart.json; empty if it lacks the methods.
std::string cost_in_words(const Json& chart);

}  // namespace tribunal
