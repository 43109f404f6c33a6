// What to say of a word that is none of the known ones.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tribunal {

/// `, did you mean "hit"?` with the known word that is nearest by edit distance, if it resembles: at most a third of
/// the letters of the longer word, rounded, are other ones. Else `, expected ` and what is given for that.
std::string suggestion(std::string_view word, const std::vector<std::string>& known, const std::string& otherwise);

}  // namespace tribunal
