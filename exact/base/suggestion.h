// What to say about a word that is not among the known ones.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tribunal {

/// `, did you mean "hit"?` with the known word that is nearest by edit distance, if it resembles the
/// word: the distance is at most a third of the longer word's length, rounded. Else `, expected ` and `otherwise`.
std::string suggestion(std::string_view word, const std::vector<std::string>& known, const std::string& otherwise);

}  // namespace tribunal
