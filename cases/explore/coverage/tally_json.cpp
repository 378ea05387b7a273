#include "cases/explore/coverage/tally_json.hpp"

#include <nlohmann/json.hpp>

#include "reports/default_estimate.hpp"

namespace crawford {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const reports::Range& range) {
    return {range.low, range.high};
}

Json json_of(const reports::CoverageTally& t) {
    Json shapes;
    for (const auto& [shape, of] : t.shapes)
        shapes[name(shape)] = {{"sets", of.sets}, {"answered", of.answered}, {"held", of.held}};
    return {{"problems", t.problems},
            {"quantities", t.quantities},
            {"sets", t.sets},
            {"answered", t.answered},
            {"held", t.held},
            {"coverage", t.coverage},
            {"resampled_95", json_of(t.resampled)},
            {"finest_held", t.finest_held},
            {"binomial_95", json_of(t.binomial)},
            {"median_half_width", t.median_width},
            {"nine_in_ten_half_width", t.upper_width},
            {"median_relative_half_width", t.median_relative},
            {"shapes", shapes}};
}

Json json_of(const TalliedEstimate& t) {
    return {{"name", t.name},
            {"grids", t.grids},
            {"choosing", json_of(t.choosing)},
            {"reporting", json_of(t.reporting)},
            {"factor_for_95", t.factor ? Json(*t.factor) : Json(nullptr)},
            {"reporting_with_factor", t.calibrated ? json_of(*t.calibrated) : Json(nullptr)}};
}

Json json_of(const reports::KnownSeries& series) {
    const std::string why = left_out(series);
    return {{"problem", series.problem},
            {"name", series.name},
            {"order", series.order},
            {"h", series.h},
            {"values", series.values},
            {"truth", series.truth},
            {"left_out", why.empty() ? Json(nullptr) : Json(why)}};
}

}  // namespace

std::string json_of(const std::vector<reports::KnownSeries>& all,
                    const std::vector<TalliedEstimate>& tallied) {
    const auto chosen = choice(tallied);
    Json json{{"wanted", wanted_coverage},
              {"default", reports::default_estimate},
              {"chosen", chosen ? Json(*chosen) : Json(nullptr)}};
    auto& estimates = json["estimates"] = Json::array();
    for (const TalliedEstimate& t : tallied) estimates.push_back(json_of(t));
    auto& quantities = json["quantities"] = Json::array();
    for (const reports::KnownSeries& series : all) quantities.push_back(json_of(series));
    return json.dump(1) + '\n';
}

}  // namespace crawford
