// A plugin promises to throw nothing. What it throws all the same becomes a fault.
#pragma once

#include <exception>
#include <string>

#include "exact/base/foreign_code.h"
#include "exact/plugin/calls.h"

namespace tribunal {

/// What the call returns. Fails with CallFailed where it throws.
template <class Call>
auto without_exceptions(const Call& call) {
  std::string what = "an exception of its own";
  try {
    const ForeignCode theirs;
    return call();
  } catch (const std::exception& error) {
    what = error.what();
  } catch (...) {
  }
  throw CallFailed{{Status::threw, what}};
}

}  // namespace tribunal
