/// Points of the extremes as records, and what each comes to.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "cases/explore/extreme_map.hpp"
#include "reports/record_store.hpp"

namespace crawford {

enum class Standing {
    right,     ///< without a word, within `wrong`
    remarked,  ///< told, whatever it is worth
    refused,   ///< not begun or not ended, with the reason
    wrong      ///< without a word
};

/// "right", "remarked", "refused", "wrong".
const char* name(Standing standing);

struct JudgedPoint {
    ExtremePoint point;
    Standing standing = Standing::wrong;
    std::string quantity = {};  ///< in which it is furthest off
    double error = 0.0;         ///< relative; NaN where nothing can be compared
    std::string said = {};      ///< names of remarks, words of refusal and failure
    bool needlessly = false;    ///< refused, and right when it is burnt all the same
    bool misled = false;        ///< the step that it is advised to take does not help
    bool is_sound() const;      ///< within `wrong`, whatever was said
};

/// Records of the points, kept in out/records by the sources they are made of.
std::shared_ptr<reports::RecordStore> records_of_points(const std::filesystem::path& out);

/// What the record of a point comes to; it is made, and kept, where there is none.
JudgedPoint judged(const ExtremePoint& point, reports::RecordStore& store);

/// { setting, class, quantity, error, said }
nlohmann::ordered_json json_of(const JudgedPoint& judged);

}  // namespace crawford
