// What is left out changes nothing that is asked for: the answer has the shape of the whole, and its
// numbers.
#include "solver/run/reduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "solver/run/burn.hpp"
#include "solver/run/history_row.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/scratch.hpp"

namespace crawford {
namespace {

/// Far above the solvers' tolerances, far below what a figure shows.
constexpr double same = 1e-6;

Scene burning(Scene scene) {
    scene.physics.regression = Regression::pyrolysis;
    scene.time = {.step = 40e-6, .end = 4e-3};
    return scene;
}

Scene whole_sandwich() {
    Scene scene = burning(testing::sandwich(16, 24));
    scene.domain.clustering_x = 1.0;
    return scene;
}

Scene wide_slab() {
    Scene scene = burning(testing::slab(ammonium_perchlorate(), 48));
    scene.domain.width = 40e-6;
    scene.domain.nx = 8;
    scene.surface.heat_flux = {8.368e6};
    return scene;
}

double size_of(double value) {
    return std::abs(value);
}
double size_of(const Vector& value) {
    return value.norm();
}
double size_of(const PlaneStress& s) {
    return std::abs(s.s11) + std::abs(s.s22) + std::abs(s.s33) + std::abs(s.s12);
}
double size_of(const std::array<double, 3>& e) {
    return std::abs(e[0]) + std::abs(e[1]) + std::abs(e[2]);
}
PlaneStress operator-(const PlaneStress& a, const PlaneStress& b) {
    return {a.s11 - b.s11, a.s22 - b.s22, a.s33 - b.s33, a.s12 - b.s12};
}
std::array<double, 3> operator-(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class Value>
void expect_same(const Lattice<Value>& a, const Lattice<Value>& b, const char* what) {
    ASSERT_EQ(a.columns(), b.columns()) << what;
    ASSERT_EQ(a.rows(), b.rows()) << what;
    double largest = 0.0, difference = 0.0;
    for (int i = 0; i < a.columns(); ++i)
        for (int j = 0; j < a.rows(); ++j) {
            largest = std::max(largest, size_of(b(i, j)));
            difference = std::max(difference, size_of(a(i, j) - b(i, j)));
        }
    EXPECT_LE(difference, same * largest) << what;
}

void expect_same(const Snapshot& a, const Snapshot& b) {
    expect_same(a.position, b.position, "position");
    expect_same(a.material_indicator, b.material_indicator, "material indicator");
    expect_same(a.temperature, b.temperature, "temperature");
    expect_same(a.velocity, b.velocity, "velocity");
    expect_same(a.reference_map, b.reference_map, "reference map");
    expect_same(a.material, b.material, "material");
    expect_same(a.stress, b.stress, "stress");
    expect_same(a.pressure, b.pressure, "pressure");
    expect_same(a.strain, b.strain, "strain");
    expect_same(a.strain_norm, b.strain_norm, "strain norm");
}

class Reduced : public ::testing::TestWithParam<Scene> {};

TEST_P(Reduced, HasTheShapeAndTheNumbersOfTheWhole) {
    const Scene& asked = GetParam();
    const Reduction reduction = reduced(asked);
    Simulation part(reduction.scene), whole(asked);
    ASSERT_LT(part.grid().cell_columns(), whole.grid().cell_columns());
    EXPECT_NE(reduction.left_out, "");
    run_to_end(part);
    run_to_end(whole);
    expect_same(reduction.widening.whole(collect_snapshot(part)), collect_snapshot(whole));

    const HistoryRow a = history_row(part, part.summary(), reduction.widening);
    const HistoryRow b = history_row(whole, whole.summary(), Widening());
    for (const auto member : {&HistoryRow::mean_burn_rate, &HistoryRow::regression_rate,
                              &HistoryRow::largest_temperature, &HistoryRow::least_temperature,
                              &HistoryRow::largest_strain, &HistoryRow::strain_about_peak,
                              &HistoryRow::largest_pressure, &HistoryRow::pressure_about_peak})
        EXPECT_NEAR(a.*member / (b.*member), 1.0, same);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Reduced, ::testing::Values(whole_sandwich(), wide_slab()),
                         [](const auto& scene) { return scene.index == 0 ? "Sandwich" : "Slab"; });

TEST(Reduction, LeavesWhatVariesAsItIs) {
    EXPECT_EQ(reduced(testing::slab(htpb_binder(), 24)).left_out, "") << "one column";
    Scene rippled = wide_slab();
    rippled.surface.ripple = Ripple{};
    EXPECT_EQ(reduced(rippled).scene.domain.nx, rippled.domain.nx);
    Scene halved = whole_sandwich();
    halved.domain.half = true;
    EXPECT_EQ(reduced(halved).left_out, "");
    Scene odd = whole_sandwich();
    odd.domain.nx = 18;  // a patch of 2 x 2 cells lies across the middle
    EXPECT_FALSE(reduced(odd).scene.domain.half);
}

class ReducedBurn : public OutputTest {};

TEST_F(ReducedBurn, GoesOnFromItsOwnCheckpoint) {
    Scene scene = whole_sandwich();
    scene.output.checkpoint_every = 2e-3;
    const auto burnt = [&](const Reduction& reduction, const std::string& folder) {
        return burn(reduction, {.name = "run", .directory = directory / folder});
    };
    const BurnOutcome unbroken = burnt(reduced(scene), "part");
    const auto checkpoint = directory / "part" / "run_checkpoint_000050.h5";
    const BurnOutcome restarted = burn(
        reduced(scene), {.name = "run", .directory = directory / "again", .restart = checkpoint});
    EXPECT_EQ(restarted.summary.mean_burn_rate, unbroken.summary.mean_burn_rate);
    EXPECT_THROW(burn(as_written(scene),
                      {.name = "run", .directory = directory / "other", .restart = checkpoint}),
                 InputError);
}

}  // namespace
}  // namespace crawford
