#include "reports/ledger_json.hpp"

#include <fmt/format.h>

#include <array>

namespace crawford::reports {

namespace {

using Json = JsonMember::Json;

constexpr std::array standings = {Standing::reproduced, Standing::other_reading,
                                  Standing::not_reproduced};

/// Null where it is missing. What is not finite becomes null when the document is written.
Json maybe(const std::optional<double>& number) {
    return number ? Json(*number) : Json();
}

}  // namespace

void to_json(Json& json, const Uncertainty& u) {
    json = {{"grid", maybe(u.grid)}, {"step", maybe(u.step)}, {"packs", maybe(u.packs)}};
}

void to_json(Json& json, const LedgerRow& row) {
    json = {{"claim", row.claim},
            {"where", row.where},
            {"entry", row.entry},
            {"unit", row.unit},
            {"paper", row.paper},
            {"ours", row.ours},
            {"paper_value", maybe(row.paper_value)},
            {"value", maybe(row.value)},
            {"uncertainty", row.uncertainty},
            {"reading", row.reading},
            {"standing", name(row.standing)},
            {"why", row.why}};
}

void to_json(Json& json, const Quantity& quantity) {
    json = {{"name", quantity.name}, {"unit", quantity.unit}, {"paper", maybe(quantity.paper)}};
}

void to_json(Json& json, const ReadingRun& run) {
    json = {{"reading", run.reading},
            {"set", run.set},
            {"values", run.values},
            {"distance", run.distance},
            {"failure", run.failure}};
}

void to_json(Json& json, const ReadingMatrix& matrix) {
    json = {{"title", matrix.title},
            {"grid", matrix.grid},
            {"quantities", matrix.quantities},
            {"runs", matrix.runs}};
}

void to_json(Json& json, const Refinement& r) {
    json = {{"quantity", r.quantity},   {"of", r.of},
            {"direction", r.direction}, {"unit", r.unit},
            {"sizes", r.sizes},         {"size_unit", r.size_unit},
            {"values", r.values},       {"used", r.used},
            {"order", maybe(r.order)},  {"extrapolated", maybe(r.extrapolated)},
            {"index", maybe(r.index)},  {"verdict", r.verdict}};
}

void to_json(Json& json, const Spread& spread) {
    json = {{"quantity", spread.quantity}, {"unit", spread.unit}, {"seeds", spread.seeds},
            {"values", spread.values},     {"mean", spread.mean}, {"deviation", spread.deviation}};
}

void to_json(Json& json, const Ledger& ledger) {
    json = {{"manifest", Json::parse(ledger.manifest)},
            {"rows", ledger.rows},
            {"readings", ledger.readings},
            {"refinements", ledger.refinements},
            {"spreads", ledger.spreads}};
}

namespace {

/// One value for each of `expected` things, or refused.
std::vector<double> one_for_each(const JsonMember& values, size_t expected, const char* of) {
    auto numbers = values.numbers();
    if (numbers.size() != expected)
        values.refuse(fmt::format("has {} values for {} {}", numbers.size(), expected, of));
    return numbers;
}

Standing standing(const JsonMember& json) {
    const auto word = json.text();
    for (const Standing s : standings)
        if (word == name(s)) return s;
    json.refuse(fmt::format("is \"{}\", none of \"{}\", \"{}\", \"{}\"", word, name(standings[0]),
                            name(standings[1]), name(standings[2])));
}

LedgerRow row(const JsonMember& json) {
    const auto uncertainty = json.at("uncertainty");
    return {.claim = json.at("claim").text(),
            .where = json.at("where").text(),
            .entry = json.at("entry").text(),
            .unit = json.at("unit").text(),
            .paper = json.at("paper").text(),
            .ours = json.at("ours").text(),
            .paper_value = json.at("paper_value").optional_number(),
            .value = json.at("value").optional_number(),
            .uncertainty = {.grid = uncertainty.at("grid").optional_number(),
                            .step = uncertainty.at("step").optional_number(),
                            .packs = uncertainty.at("packs").optional_number()},
            .reading = json.at("reading").text(),
            .standing = standing(json.at("standing")),
            .why = json.at("why").text()};
}

ReadingMatrix reading_matrix(const JsonMember& json) {
    ReadingMatrix matrix{.title = json.at("title").text(), .grid = json.at("grid").text()};
    for (const JsonMember& quantity : json.at("quantities").items())
        matrix.quantities.push_back({.name = quantity.at("name").text(),
                                     .unit = quantity.at("unit").text(),
                                     .paper = quantity.at("paper").optional_number()});
    for (const JsonMember& run : json.at("runs").items())
        matrix.runs.push_back(
            {.reading = run.at("reading").text(),
             .set = run.at("set").texts(),
             .values = one_for_each(run.at("values"), matrix.quantities.size(), "quantities"),
             .distance = run.at("distance").number(),
             .failure = run.at("failure").text()});
    return matrix;
}

Refinement refinement(const JsonMember& json) {
    const auto sizes = json.at("sizes").numbers();
    return {.quantity = json.at("quantity").text(),
            .of = json.at("of").text(),
            .direction = json.at("direction").text(),
            .unit = json.at("unit").text(),
            .sizes = sizes,
            .size_unit = json.at("size_unit").text(),
            .values = one_for_each(json.at("values"), sizes.size(), "sizes"),
            .used = json.at("used").number(),
            .order = json.at("order").optional_number(),
            .extrapolated = json.at("extrapolated").optional_number(),
            .index = json.at("index").optional_number(),
            .verdict = json.at("verdict").text()};
}

Spread spread(const JsonMember& json) {
    Spread s{.quantity = json.at("quantity").text(), .unit = json.at("unit").text()};
    for (const JsonMember& seed : json.at("seeds").items()) s.seeds.push_back(seed.count());
    s.values = one_for_each(json.at("values"), s.seeds.size(), "seeds");
    s.mean = json.at("mean").number();
    s.deviation = json.at("deviation").number();
    return s;
}

}  // namespace

Ledger ledger_of(const JsonMember& json) {
    Ledger ledger;
    ledger.manifest = json.at("manifest").object().dump();
    for (const JsonMember& item : json.at("rows").items()) ledger.rows.push_back(row(item));
    for (const JsonMember& item : json.at("readings").items())
        ledger.readings.push_back(reading_matrix(item));
    for (const JsonMember& item : json.at("refinements").items())
        ledger.refinements.push_back(refinement(item));
    for (const JsonMember& item : json.at("spreads").items())
        ledger.spreads.push_back(spread(item));
    return ledger;
}

}  // namespace crawford::reports
