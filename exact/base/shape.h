// What a record must look like before anybody reads it: a shape for each value, made of the shapes of its parts.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "exact/base/record.h"

namespace tribunal::shape {

/// Fails with Exit::bad_input, at the place of the value, unless the value is one of the shape.
using Check = std::function<void(const Record&)>;

Check text();
/// A text that is not empty.
Check name();
Check truth();
/// A whole number from 0 to `most`.
Check count(std::uint64_t most = Record::most_count);
/// Any of 64 bits: a seed.
Check whole();
Check integer(std::int64_t least, std::int64_t most);
Check number(double least, double most);
/// A number from 0 to 1.
Check share();
/// One of these texts.
Check word(std::initializer_list<std::string_view> words);
Check format();

Check null_or(Check shape);
/// A value that has one of the shapes; `expected` names them.
Check either(std::initializer_list<Check> shapes, const char* expected);

Check list(Check of_item);
/// An object with any names, all of whose members are of one shape.
Check named(Check of_member);

struct Member {
  std::string_view key;
  Check shape;
  bool is_needed = true;
};

Member needed(std::string_view key, Check shape);
Member if_there(std::string_view key, Check shape);

/// An object with these members and any others; `also` checks how its members go together.
Check object(std::vector<Member> members, Check also = {});

// --- how figures go together ----------------------------------------------------------------------------------------

/// Fails unless part ≤ whole.
void require_part(const Record& row, std::uint64_t part, std::uint64_t whole, const char* what);

/// Fails unless the members "share", "lower" and "upper", those that are there, can be of `part` in `whole`.
void require_share(const Record& row, std::uint64_t part, std::uint64_t whole);

/// The sum of counts whose names are not known; fails where it is beyond a count.
std::uint64_t sum_of(const Record& counts);

}  // namespace tribunal::shape
