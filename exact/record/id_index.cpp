#include "exact/record/id_index.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace tribunal {
namespace {

constexpr std::size_t spool_count = 64, memory_each = std::size_t{1} << 14;

/// Both halves of the product, folded.
std::uint64_t folded(std::uint64_t a, std::uint64_t b) {
  const auto product = static_cast<unsigned __int128>(a) * b;
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

// Odd, and with as many ones as zeros: digits of pi.
constexpr std::uint64_t one = 0x243f6a8885a308d3, two = 0x13198a2e03707345, three = 0xa4093822299f31d1;

/// One pair per case number: the pair with the earliest second case.
std::optional<SameId> repeated_in(const std::vector<IdEntry>& sorted, std::optional<SameId> best) {
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].fingerprint() != sorted[i - 1].fingerprint()) continue;
    const bool begins = i < 2 || sorted[i - 2].fingerprint() != sorted[i].fingerprint();
    if (begins && (!best || sorted[i].number < best->second)) best = {sorted[i - 1].number, sorted[i].number};
  }
  return best;
}

}  // namespace

Fingerprint fingerprint_of(std::string_view id) {
  std::uint64_t a = one ^ id.size(), b = two;
  for (std::size_t at = 0; at < id.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, id.data() + at, std::min<std::size_t>(8, id.size() - at));
    a = folded(a ^ word, three) + b;
    b = folded(b ^ std::rotl(word, 29), two) ^ a;
  }
  return {folded(a ^ one, b | 1), static_cast<std::uint32_t>(folded(b ^ three, a | 1) >> 32)};
}

std::optional<SameId> IdIndex::sort() {
  std::ranges::sort(entries_);
  return repeated_in(entries_, {});
}

std::optional<std::uint32_t> IdIndex::find(const Fingerprint& f) const {
  const auto at = std::ranges::lower_bound(entries_, f, {}, &IdEntry::fingerprint);
  if (at == entries_.end() || at->fingerprint() != f) return {};
  return at->number;
}

IdSpools::IdSpools() {
  for (std::size_t i = 0; i < spool_count; ++i) spools_.emplace_back(memory_each);
}

void IdSpools::add(const Fingerprint& f) {
  const IdEntry entry{f.high, f.low, cases_++};
  char bytes[sizeof entry];
  std::memcpy(bytes, &entry, sizeof entry);
  spools_[f.high >> 58].write({bytes, sizeof bytes});
}

std::optional<SameId> IdSpools::first_repeated() const {
  std::optional<SameId> first;
  for (const Spool& spool : spools_) {
    std::vector<IdEntry> entries(static_cast<std::size_t>(spool.size() / sizeof(IdEntry)));
    std::string bytes = spool.at(0, static_cast<std::size_t>(spool.size()));
    std::memcpy(static_cast<void*>(entries.data()), bytes.data(), bytes.size());
    std::ranges::sort(entries);
    first = repeated_in(entries, first);
  }
  return first;
}

}  // namespace tribunal
