#include "reference/truth_registry.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <ostream>
#include <set>

#include "base/errors.hpp"
#include "base/source_tree.hpp"
#include "reference/elastic_laminate.hpp"
#include "reference/manufactured_burning.hpp"
#include "reference/slab.hpp"

namespace crawford::reference {

/// How a test is called that walks the registry. The name is GoogleTest's.
// NOLINTNEXTLINE(readability-identifier-naming)
static void PrintTo(const TruthEntry& entry, std::ostream* out) {
    *out << entry.name;
}

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// What an action says when it refuses its input; empty where it does not.
template <class Action>
std::string refusal(const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// A number just beyond what the limits allow, if there is one beside infinity.
double beyond(const Limits& limits) {
    if (!limits.contains(std::numeric_limits<double>::infinity()))
        return std::numeric_limits<double>::infinity();
    return std::numeric_limits<double>::quiet_NaN();
}

/// Finite elements need not be fine here.
Parameters coarse(const TruthEntry& entry, Parameters given = {}) {
    for (const Parameter& parameter : entry.parameters) {
        if (parameter.name == "degree") given.try_emplace("degree", 3.0);
        if (parameter.name == "layers") given.try_emplace("layers", 2.0);
    }
    return given;
}

/// Two alike have no corner; and where they are heated differently, not that front.
bool needs_two_materials(const TruthEntry& entry, const Parameter& parameter,
                         const std::string& choice) {
    return (entry.name == "williams-corner" || entry.name == "burning-sandwich-front") &&
           ParameterValue(choice) != parameter.standard;
}

class EveryTruth : public testing::TestWithParam<TruthEntry> {};

TEST_P(EveryTruth, HasFiniteValuesAtItsExamples) {
    const TruthEntry& entry = GetParam();
    ASSERT_FALSE(entry.examples.empty());
    const FieldTable table = entry.make(coarse(entry)).values(entry.examples, entry.example_time);
    ASSERT_EQ(table.fields().size(), entry.fields.size());
    ASSERT_EQ(table.values().rows(), static_cast<Eigen::Index>(entry.examples.size()));
    EXPECT_TRUE(table.values().allFinite());
    for (size_t k = 0; k < entry.fields.size(); ++k)
        EXPECT_EQ(table.fields()[k].name, entry.fields[k].name);
}

TEST_P(EveryTruth, SaysWhatItIsAndInWhatUnits) {
    const TruthEntry& entry = GetParam();
    EXPECT_FALSE(entry.description.empty());
    EXPECT_FALSE(entry.source.empty());
    std::set<std::string> names;
    for (const Field& field : entry.fields) {
        EXPECT_TRUE(names.insert(field.name).second) << field.name << " is there twice";
        EXPECT_FALSE(field.unit.empty()) << field.name;
        EXPECT_FALSE(field.meaning.empty()) << field.name;
    }
    names.clear();
    for (const Parameter& parameter : entry.parameters) {
        EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name << " is there twice";
        EXPECT_EQ(parameter.unit.empty(), parameter.is_text()) << parameter.name;
        EXPECT_FALSE(parameter.meaning.empty()) << parameter.name;
        EXPECT_TRUE(parameter.standard || !parameter.otherwise.empty()) << parameter.name;
    }
}

TEST_P(EveryTruth, TakesItsOwnStandards) {
    const TruthEntry& entry = GetParam();
    const auto values = [&](const Parameters& given) {
        return entry.make(given).values(entry.examples, entry.example_time).values();
    };
    Parameters standards = coarse(entry);
    for (const Parameter& parameter : entry.parameters)
        if (parameter.standard) standards.try_emplace(parameter.name, *parameter.standard);
    EXPECT_EQ(values(standards), values(coarse(entry)));
}

TEST_P(EveryTruth, TakesEveryChoice) {
    const TruthEntry& entry = GetParam();
    for (const Parameter& parameter : entry.parameters)
        for (const std::string& choice : parameter.choices) {
            if (needs_two_materials(entry, parameter, choice)) continue;
            const Truth truth = entry.make(coarse(entry, {{parameter.name, choice}}));
            EXPECT_NO_THROW(truth.values(entry.examples, entry.example_time))
                << parameter.name << " = " << choice;
        }
}

TEST_P(EveryTruth, RefusesEachParameterOutOfItsLimits) {
    const TruthEntry& entry = GetParam();
    const auto expect_refused = [&](const std::string& name, const ParameterValue& value) {
        EXPECT_THAT(refusal([&] {
                        entry.make({{name, value}});
                    }),
                    StartsWith(entry.name + ": " + name + " = "));
    };
    for (const Parameter& parameter : entry.parameters) {
        if (parameter.is_text()) {
            expect_refused(parameter.name, "nonsense");
            expect_refused(parameter.name, 1.0);
            continue;
        }
        expect_refused(parameter.name, "nonsense");
        expect_refused(parameter.name, std::numeric_limits<double>::quiet_NaN());
        expect_refused(parameter.name, beyond(parameter.limits));
        const Limits& range = parameter.limits;
        if (std::isfinite(range.from))
            expect_refused(parameter.name, range.open ? range.from : range.from - 1.0);
        if (std::isfinite(range.to))
            expect_refused(parameter.name, range.open ? range.to : range.to + 1.0);
        if (range.whole) expect_refused(parameter.name, range.from + 0.5);
    }
}

/// What it answers is finite, and what it throws is one of the two that callers know.
void ask_far_out(const TruthEntry& entry, const std::string& parameter, double value) {
    try {
        const Truth truth = entry.make(coarse(entry, {{parameter, value}}));
        truth.values(entry.examples, entry.example_time);
    } catch (const InputError&) {        // NOLINT(bugprone-empty-catch): a good ending
    } catch (const NumericalFailure&) {  // NOLINT(bugprone-empty-catch): another
    } catch (const std::exception& other) {
        ADD_FAILURE() << parameter << " = " << value << ": " << other.what();
    }
}

TEST_P(EveryTruth, AnswersOrSaysWhyNotFarFromItsStandards) {
    const TruthEntry& entry = GetParam();
    for (const Parameter& parameter : entry.parameters) {
        if (!parameter.standard || parameter.is_text() || parameter.limits.whole) continue;
        const double standard = std::get<double>(*parameter.standard);
        for (const double factor : {1e-290, 1e-30, 1e-6, 1e6, 1e30, 1e290})
            ask_far_out(entry, parameter.name, (standard == 0.0 ? 1.0 : standard) * factor);
    }
}

TEST_P(EveryTruth, RefusesAnUnknownParameterWithTheNearestName) {
    const TruthEntry& entry = GetParam();
    const std::string name = entry.parameters.back().name;
    EXPECT_THAT(refusal([&] {
                    entry.make({{name + "s", 1.0}});
                }),
                AllOf(StartsWith(entry.name + ": unknown parameter " + name + "s"),
                      HasSubstr("did you mean " + name)));
}

TEST_P(EveryTruth, RefusesPointsOutsideItsDomain) {
    const TruthEntry& entry = GetParam();
    const Truth truth = entry.make(coarse(entry));
    const Domain& domain = truth.domain();
    const auto refused_at = [&](const Eigen::Vector2d& point) {
        return refusal([&] { truth.values(std::vector{point}, entry.example_time); });
    };
    const Eigen::Vector2d point = entry.examples.front();
    const double level = domain.surface ? domain.surface(point.x(), entry.example_time) : 0.0;
    EXPECT_EQ(refused_at(point), "");
    EXPECT_THAT(refused_at({std::nan(""), point.y()}), HasSubstr("x must be"));
    for (const double y : {domain.y.from - 1.0, domain.y.to + 1.0})
        EXPECT_THAT(refused_at({point.x(), level + y}), HasSubstr("must be"));
    for (const double x : {domain.x.from - 1.0, domain.x.to + 1.0})
        EXPECT_THAT(refused_at({x, point.y()}), HasSubstr("x must be"));
    EXPECT_THAT(refusal([&] { truth.values(std::vector{point}, domain.time.from - 1.0); }),
                HasSubstr("time = "));
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryTruth, testing::ValuesIn(truths()), [](const auto& entry) {
    std::string name = entry.param.name;
    std::ranges::replace(name, '-', '_');
    return name;
});

TEST(TruthRegistry, NamesAreUnique) {
    std::set<std::string> names;
    for (const TruthEntry& entry : truths()) EXPECT_TRUE(names.insert(entry.name).second);
}

TEST(TruthRegistry, IsInTheDocumentation) {
    std::ifstream file(source_path("docs/truths.md"));
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    for (const TruthEntry& entry : truths()) EXPECT_THAT(page, HasSubstr("`" + entry.name + "`"));
}

TEST(TruthRegistry, NamesTheNearestOfAnUnknownTruth) {
    EXPECT_THAT(refusal([] { find_truth("slap"); }), "unknown truth slap; did you mean slab?");
}

TEST(TruthRegistry, NamesTheNearestOfAnUnknownField) {
    const TruthEntry& slab = find_truth("slab");
    EXPECT_THAT(refusal([&] { slab.make().values(slab.examples).column("temprature"); }),
                "unknown field temprature; did you mean temperature?");
}

TEST(TruthRegistry, SlabIsTheSlab) {
    const Slab slab({.material = without_reaction(binder()),
                     .model = SlabModel::kuznetsov_stewart,
                     .thermal_stress = ThermalStress::alpha_k,
                     .heat_flux = 4e6,
                     .burn_rate = 0.004,
                     .pressure = 3e6,
                     .cold_temperature = 290.0,
                     .depth = 400e-6});
    const std::vector<Eigen::Vector2d> points{{0.0, 0.0}, {1e-5, -4e-4}, {2e-5, -30e-6}};
    const FieldTable table = truth("slab", {{"material", "binder"},
                                            {"heat_of_reaction", 0.0},
                                            {"model", "kuznetsov_stewart"},
                                            {"thermal_stress", "alpha K"},
                                            {"heat_flux", 4e6},
                                            {"burn_rate", 0.004},
                                            {"pressure", 3e6},
                                            {"cold_temperature", 290.0},
                                            {"depth", 400e-6}})
                                 .values(points);
    const auto states = slab.states(std::vector{0.0, -4e-4, -30e-6});
    for (size_t k = 0; k < points.size(); ++k) {
        EXPECT_EQ(table.column("temperature")[k], states[k].temperature);
        EXPECT_EQ(table.column("temperature_gradient_y")[k], states[k].temperature_gradient);
        EXPECT_EQ(table.column("velocity_y")[k], states[k].velocity);
        EXPECT_EQ(table.column("stress_xx")[k], states[k].stress_11);
        EXPECT_EQ(table.column("stress_yy")[k], states[k].stress_22);
        EXPECT_EQ(table.column("stress_zz")[k], states[k].stress_33);
        EXPECT_EQ(table.column("pressure")[k], states[k].pressure);
        EXPECT_EQ(table.column("deformation_gradient_yy")[k], states[k].deformation_gradient_22);
        EXPECT_EQ(table.column("surface_temperature")[k], slab.surface_temperature());
        EXPECT_EQ(table.column("burn_rate")[k], slab.burn_rate());
    }
}

TEST(TruthRegistry, LaminateIsTheLaminate) {
    const ElasticLaminate laminate({.inner = binder(),
                                    .outer = ap(),
                                    .period = 200e-6,
                                    .strip = 70e-6,
                                    .axial_strain = 2e-3,
                                    .shear = 1e-3});
    const Truth same =
        truth("elastic-laminate",
              {{"width", 200e-6}, {"strip", 70e-6}, {"axial_strain", 2e-3}, {"shear", 1e-3}});
    const std::vector<Eigen::Vector2d> points{{10e-6, 5e-6}, {60e-6, -20e-6}, {-90e-6, 1e-3}};
    const FieldTable table = same.values(points);
    for (size_t k = 0; k < points.size(); ++k) {
        const auto u = laminate.displacement(points[k].x(), points[k].y());
        const PlaneStrainStress stress = laminate.stress(points[k].x());
        EXPECT_EQ(table.column("displacement_x")[k], u.x());
        EXPECT_EQ(table.column("displacement_y")[k], u.y());
        EXPECT_EQ(table.column("stress_xx")[k], stress.xx);
        EXPECT_EQ(table.column("stress_yy")[k], stress.yy);
        EXPECT_EQ(table.column("stress_zz")[k], stress.zz);
        EXPECT_EQ(table.column("stress_xy")[k], stress.xy);
        EXPECT_EQ(table.column("pressure")[k], stress.pressure());
    }
}

TEST(TruthRegistry, ManufacturedBurningIsTheManufacturedBurning) {
    const ManufacturedBurning solid({.material = ap(),
                                     .width = 240e-6,
                                     .depth = 200e-6,
                                     .regression_rate = 0.005,
                                     .wave_height = 5e-6,
                                     .wave_frequency = 250.0,
                                     .bottom_temperature = 310.0,
                                     .displacement = 3e-6,
                                     .motion_frequency = 200.0,
                                     .stress = 1e6,
                                     .gas_pressure = 1.5e6,
                                     .gas_flux = 7e6});
    const Truth same = truth("manufactured-burning", {{"depth", 200e-6},
                                                      {"regression_rate", 0.005},
                                                      {"wave_height", 5e-6},
                                                      {"wave_frequency", 250.0},
                                                      {"bottom_temperature", 310.0},
                                                      {"displacement", 3e-6},
                                                      {"motion_frequency", 200.0},
                                                      {"stress", 1e6},
                                                      {"pressure", 1.5e6},
                                                      {"heat_flux", 7e6}});
    const double x = 70e-6, y = -50e-6, t = 2e-3;
    const FieldTable table = same.values(std::vector{Eigen::Vector2d(x, y)}, t);
    const auto at = [&](const char* field) { return table.column(field).front(); };
    EXPECT_EQ(at("surface"), solid.surface(x, t));
    EXPECT_EQ(at("temperature"), solid.temperature(x, y, t));
    EXPECT_EQ(at("temperature_rate"), solid.temperature_rate(x, y, t));
    EXPECT_EQ(at("velocity_x"), solid.velocity(x, y, t).x());
    EXPECT_EQ(at("velocity_y"), solid.velocity(x, y, t).y());
    EXPECT_EQ(at("velocity_gradient_xy"), solid.velocity_gradient(x, y, t)(0, 1));
    EXPECT_EQ(at("velocity_gradient_yx"), solid.velocity_gradient(x, y, t)(1, 0));
    EXPECT_EQ(at("displacement_x"), -solid.shift(x, y, t).x());
    EXPECT_EQ(at("reference_map_y"), y + solid.shift(x, y, t).y());
    EXPECT_EQ(at("deformation_gradient_xy"), solid.deformation_gradient(x, y, t)(0, 1));
    EXPECT_EQ(at("stress_xx"), solid.stress(x, y, t).xx);
    EXPECT_EQ(at("stress_yy"), solid.stress(x, y, t).yy);
    EXPECT_EQ(at("stress_zz"), solid.stress(x, y, t).zz);
    EXPECT_EQ(at("stress_xy"), solid.stress(x, y, t).xy);
    EXPECT_EQ(at("heat_source"), solid.heat_source(x, y, t));
    EXPECT_EQ(at("stress_source_yy"), solid.stress_source(x, y, t).yy);
    EXPECT_EQ(at("stress_source_xy"), solid.stress_source(x, y, t).xy);
    EXPECT_EQ(at("body_force_x"), solid.body_force(x, y, t).x());
    EXPECT_EQ(at("surface_heat_flux"), solid.heat_flux(x, t));
    EXPECT_EQ(at("surface_traction_y"), solid.traction(x, t).y());
}

}  // namespace

}  // namespace crawford::reference
