// Contracts in logs, certificates and counterexamples.
#pragma once

#include <span>

#include "core/contract.h"
#include "core/method.h"
#include "exact/base/record.h"

namespace tribunal {

/// All that the contract says: {"probes":["segment","ray"],"triangles":"any",…}.
Json from_contract(const Contract& c);

/// What records say of the methods that they are about: `name`, `number`, `fmt`, `convention`, `exact`.
Json methods_json(std::span<const Method> methods);

/// Fails, naming the key, where a word is missing or unknown.
Contract to_contract(const Record& terms);

/// Adds to a finding how the contract reads contacts: "convention", and "readings" with those that differ from the
/// default, if there are any.
void add_readings(Json& finding, const Contract& c);

/// A contract that takes all operands and reads contacts as the finding says.
Contract readings_in(const Record& finding);

}  // namespace tribunal
