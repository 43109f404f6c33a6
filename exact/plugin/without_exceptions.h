// A plugin promises to throw nothing. What it throws all the same becomes a fault.
#pragma once

#include <exception>
#include <string>

#include "exact/base/foreign_code.h"
#include "exact/base/shown.h"
#include "exact/plugin/calls.h"

namespace tribunal {

/// Of the text of an exception, which may be any bytes.
inline constexpr std::size_t longest_what = 300;

/// What the call returns. Fails with CallFailed where it throws.
template <class Call>
auto without_exceptions(const Call& call) {
  std::string what = "an exception of its own";
  try {
    const ForeignCode theirs;
    return call();
  } catch (const std::exception& error) {
    what = shown_shortly(error.what(), longest_what);
  } catch (...) {
  }
  throw CallFailed{{Status::threw, what}};
}

}  // namespace tribunal
