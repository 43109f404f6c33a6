// Which case has which id, for files of any length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "exact/base/spool.h"

namespace tribunal {

/// A fingerprint of an id: 96 bits in which two ids of a file of 5 million agree by chance once in 10^16 files. Where
/// two ids of a case file agree, the file is read again and the ids themselves are compared.
struct Fingerprint {
  std::uint64_t high = 0;
  std::uint32_t low = 0;

  auto operator<=>(const Fingerprint&) const = default;
};

Fingerprint fingerprint_of(std::string_view id);

/// An id's fingerprint and the number of the case, from 0: 16 bytes. A file has at most 2^32 cases.
struct IdEntry {
  std::uint64_t high = 0;
  std::uint32_t low = 0, number = 0;

  Fingerprint fingerprint() const { return {high, low}; }
  auto operator<=>(const IdEntry&) const = default;
};
static_assert(sizeof(IdEntry) == 16);

/// Two cases with one fingerprint.
struct SameId {
  std::uint32_t first = 0, second = 0;
};

/// The fingerprints of all cases, sorted, in memory: 16 bytes a case.
class IdIndex {
 public:
  void add(const Fingerprint& f) { entries_.push_back({f.high, f.low, static_cast<std::uint32_t>(entries_.size())}); }

  /// To be called once, after the last case. The pair whose second case is the first such, if there are any.
  std::optional<SameId> sort();

  /// Of the case with this id, if there is one.
  std::optional<std::uint32_t> find(const Fingerprint& f) const;

  std::size_t size() const { return entries_.size(); }

 private:
  std::vector<IdEntry> entries_{};
};

/// The same question, whether two ids are one, in nearly constant memory: the fingerprints go to 64 spools by their
/// first bits, and only one of these, a quarter of a byte a case, is sorted at a time.
class IdSpools {
 public:
  IdSpools();
  void add(const Fingerprint& f);
  std::optional<SameId> first_repeated() const;

 private:
  std::vector<Spool> spools_{};
  std::uint32_t cases_ = 0;
};

}  // namespace tribunal
