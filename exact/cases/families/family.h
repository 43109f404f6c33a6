// Families of generated cases. Case k of a family under a seed is a pure function of (family, seed, k).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/answer.h"
#include "core/format.h"
#include "core/query.h"
#include "exact/cases/polygons/construction.h"

namespace tribunal {

/// One generated case with what is known of it by construction.
struct Trial {
  Query query{};
  Format format = Format::binary64;
  ClassId class_id = 0;                        ///< of a triangle case, by construction; 0: not known, ask an oracle
  std::uint16_t level = 0;                     ///< index into Family::levels: where on its stress axis the case lies
  std::optional<Construction> construction{};  ///< of a polygon case, if it was made by one
};

/// The file that a family's cases are made from.
struct DataFile {
  std::string kind;            ///< "cases", "mesh" or "scene"
  std::string file, sha256{};  ///< the hash of its bytes
  std::string numbers_sha256;  ///< the hash of all numbers that were read, also from files that it names
  std::size_t items = 0;       ///< how many cases, faces or probes of it are used
  std::string left_out{};      ///< what is not, and why, in words
};

/// A family: what it stresses and which population it draws from. Adding one is adding a file and a row.
struct Family {
  std::string_view name;
  std::string_view stresses;    ///< one line for people
  std::string_view population;  ///< what a sampled figure is about
  std::string_view axis;        ///< name and unit of the stress axis
  bool constructs;  ///< every case knows its class or construction, and all of these are drawn, for segments and rays
  std::span<const int> (*levels)(Format);
  std::function<Trial(Format format, std::uint64_t seed, std::uint64_t k)> make;
  Operands operands = Operands::triangles;
  std::optional<DataFile> data{};  ///< of a family of the user's own data: its cases are a function of it too
};

}  // namespace tribunal
