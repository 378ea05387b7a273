/// The ledger as JSON, out and in.
#pragma once

#include "base/json_member.hpp"
#include "reports/ledger.hpp"

namespace crawford::reports {

/// The document of a ledger and its parts. A number that is missing is null there, and so is NaN.
void to_json(JsonMember::Json& json, const Uncertainty& uncertainty);
void to_json(JsonMember::Json& json, const LedgerRow& row);
void to_json(JsonMember::Json& json, const Quantity& quantity);
void to_json(JsonMember::Json& json, const ReadingRun& run);
void to_json(JsonMember::Json& json, const ReadingMatrix& matrix);
void to_json(JsonMember::Json& json, const Refinement& refinement);
void to_json(JsonMember::Json& json, const Spread& spread);
void to_json(JsonMember::Json& json, const Ledger& ledger);

/// \throws JsonRefused naming the member that is missing or wrong.
Ledger ledger_of(const JsonMember& document);

}  // namespace crawford::reports
