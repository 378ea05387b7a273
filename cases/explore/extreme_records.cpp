#include "cases/explore/extreme_records.hpp"

#include <cmath>
#include <limits>

#include "base/build_info.hpp"
#include "base/errors.hpp"
#include "cases/explore/judged_burn.hpp"
#include "reports/record_json.hpp"
#include "solver/scene/check_scene.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

namespace {

constexpr auto experiment = "extremes, points";

/// Quantities of a record, besides the one it is judged by; 1 where it holds.
constexpr auto refused = "refused";
constexpr auto ended = "burnt to its end";
constexpr auto misled = "advice does not help";

void burn(const Scene& scene, reports::Record& record) {
    const Judged judged = judge(scene);
    record.said = judged.found.said;
    if (judged.can_be_judged) record.found->value(judged.quantity, judged.error);
    record.found->value(refused, judged.found.refused ? 1.0 : 0.0)
        .value(ended, judged.found.burns ? 1.0 : 0.0)
        .value(misled, judged.misled ? 1.0 : 0.0);
}

void fill(reports::Record& record, const ExtremePoint& point) {
    const Scene scene = point.scene();
    record.scenes = {to_toml(scene)};
    record.found = reports::Measurement();
    try {
        check(scene);
    } catch (const InputError& refusal) {
        record.said = refusal.what();
        record.found->value(refused, 1.0).value(ended, 0.0).value(misled, 0.0);
        return;
    }
    burn(scene, record);
}

bool holds(const reports::Record& record, const char* quantity) {
    return record.found->value_of(quantity) == 1.0;
}

Standing standing_of(const JudgedPoint& judged, const reports::Record& record) {
    if (holds(record, refused) || !holds(record, ended)) return Standing::refused;
    if (!judged.said.empty()) return Standing::remarked;
    return judged.is_sound() ? Standing::right : Standing::wrong;
}

JudgedPoint judged(const ExtremePoint& point, const reports::Record& record) {
    JudgedPoint judged{.point = point, .said = record.said};
    judged.error = std::numeric_limits<double>::quiet_NaN();
    if (!record.ending.is_done()) {
        judged.said = record.ending.message;  // that is no answer: it stays wrong
        return judged;
    }
    const auto& [quantity, value] = record.found->values().front();
    if (quantity != refused) {
        judged.quantity = quantity;
        judged.error = value.value;
    }
    judged.standing = standing_of(judged, record);
    judged.needlessly = holds(record, refused) && judged.is_sound();
    judged.misled = holds(record, misled);
    return judged;
}

}  // namespace

const char* name(Standing standing) {
    switch (standing) {
        case Standing::right:
            return "right";
        case Standing::remarked:
            return "remarked";
        case Standing::refused:
            return "refused";
        default:
            return "wrong";
    }
}

bool JudgedPoint::is_sound() const {
    return error <= wrong;
}

std::shared_ptr<reports::RecordStore> records_of_points(const std::filesystem::path& out) {
    return std::make_shared<reports::RecordStore>(out / "records", source_fingerprint());
}

JudgedPoint judged(const ExtremePoint& point, reports::RecordStore& store) {
    const reports::Setting setting = point.setting();
    auto record = store.find(experiment, setting);
    if (!record) {
        record = reports::record_of(experiment, setting,
                                    [&](reports::Record& made) { fill(made, point); });
        store.add(*record);
    }
    return judged(point, *record);
}

nlohmann::ordered_json json_of(const JudgedPoint& judged) {
    nlohmann::ordered_json json{{"setting", judged.point.setting()},
                                {"class", name(judged.standing)},
                                {"quantity", judged.quantity}};
    json["error"] = std::isfinite(judged.error) ? nlohmann::ordered_json(judged.error) : nullptr;
    json["said"] = judged.said;
    return json;
}

}  // namespace crawford
