/// The seed of a random pack, as a run finds it again for its manifest.
#include <gtest/gtest.h>

#include <optional>
#include <variant>

#include "base/source_tree.hpp"
#include "solver/scene/read_pack.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {
namespace {

std::optional<std::uint64_t> seed_of_scene(const Scene& scene) {
    return seed_of(std::get<Discs>(scene.morphology.shape).source);
}

TEST(PackSeed, IsThatOfTheScene) {
    const Scene scene = read_scene(source_path("cases/scenes/random_pack.toml"),
                                   {"morphology.seed=2147483647", "morphology.area_fraction=0.4"});
    EXPECT_EQ(seed_of_scene(scene), 2147483647U);
    EXPECT_EQ(seed_of_scene(parse_scene(to_toml(scene))), 2147483647U) << "burnt from a manifest";
    EXPECT_EQ(seed_of_scene(read_scene(source_path("cases/scenes/pack.toml"))), std::nullopt);
}

TEST(PackSeed, IsNotReadOutOfOtherTexts) {
    EXPECT_EQ(seed_of("a table, seed 3"), std::nullopt);
    EXPECT_EQ(seed_of("pack: of a friend, seed unknown"), std::nullopt);
    EXPECT_EQ(seed_of("pack: of a friend, seed "), std::nullopt);
    EXPECT_EQ(seed_of(""), std::nullopt);
}

}  // namespace
}  // namespace crawford
