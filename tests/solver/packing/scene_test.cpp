// Packs in scenes: read, written, refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include "base/errors.hpp"
#include "base/scratch.hpp"
#include "solver/packing/pack.hpp"
#include "solver/scene/read_discs.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/scene/write_discs.hpp"
#include "solver/scene/write_scene.hpp"
#include "tests/solver/packing/packs.hpp"

namespace crawford {
namespace {

using testing::fingerprint;
using testing::paper_pack;

constexpr const char* scene_text = R"toml(
[domain]
width = "240 um"
depth = "720 um"
nx = 60
ny = 48
[morphology]
kind = "pack"
discs = [{ radius = "38.4 um", count = 21 }, { radius = "28.8 um", count = 11 }, { radius = "17.7 um", count = 8 }]
area_fraction = 0.72
smallest_gap = "3 um"
[surface]
pressure = "2 MPa"
heat_flux = "200 cal/(s cm2)"
[time]
step = "25 us"
end = "0.135 s"
)toml";

TEST(PackScene, BecomesDiscsAndIsWrittenAsSuch) {
    const Scene scene = parse_scene(scene_text);
    const auto& shape = std::get<Discs>(scene.morphology.shape);
    EXPECT_EQ(fingerprint(shape), fingerprint(random_pack(paper_pack())));
    EXPECT_EQ(scene.morphology.materials[0].name, "AP");
    EXPECT_EQ(scene.morphology.materials[1].name, "binder");
    EXPECT_THAT(shape.source, ::testing::HasSubstr("seed 1"));
    // the manifest repeats the run without the generator
    const Scene again = parse_scene(to_toml(scene));
    EXPECT_EQ(fingerprint(std::get<Discs>(again.morphology.shape)), fingerprint(shape));
    EXPECT_EQ(std::get<Discs>(again.morphology.shape).period, shape.period);
}

TEST(PackScene, TakesADistributionOfSizes) {
    const Scene scene =
        parse_scene(scene_text, ".",
                    {"morphology.discs=[{radius='30 um', share=0.8}, {radius='15 um', share=0.2}]",
                     "morphology.count=40", "morphology.smallest_gap=1 um"});
    const auto& shape = std::get<Discs>(scene.morphology.shape);
    EXPECT_THAT(shape.source, ::testing::HasSubstr("20 of 30 um, 20 of 15 um"));
    EXPECT_NEAR(area_fraction(shape, 240e-6), 0.72, 1e-15);
    try {
        parse_scene(
            scene_text, ".",
            {"morphology.discs=[{radius='20 um', share=0.999}, {radius='10 um', share=0.001}]",
             "morphology.count=40"});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(),
                    ::testing::HasSubstr("morphology.count = 40 is too small: the share"));
    }
}

TEST(PackScene, IsWrittenAsATableWithoutLoss) {
    Discs pack = random_pack(paper_pack());
    pack.source = "somewhere\nelse";
    const Scratch scratch;
    const std::string file = scratch.path() / "table.csv";
    std::ofstream(file) << discs_csv(pack);
    const std::vector<Disc> read = read_discs(file);
    EXPECT_EQ(fingerprint({.discs = read, .period = pack.period}), fingerprint(pack));
    EXPECT_EQ(read[39].radius, pack.discs[39].radius);
}

TEST(PackScene, TakesSeedAndUnitsOfAnyKind) {
    const auto shape = [](const std::vector<std::string>& overrides) {
        return fingerprint(
            std::get<Discs>(parse_scene(scene_text, ".", overrides).morphology.shape));
    };
    const auto usual = shape({});
    EXPECT_EQ(shape({"morphology.smallest_gap=0.003 mm", "domain.width=2.4e-4 m"}), usual);
    EXPECT_EQ(shape({"domain.nx=120", "domain.depth=480 um"}), usual) << "a grid makes no pack";
    EXPECT_NE(shape({"morphology.seed=2"}), usual);
}

TEST(PackScene, IsRefusedInOneLine) {
    const auto refusal = [](const std::string& override) -> std::string {
        try {
            parse_scene(scene_text, ".", {override});
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing";
    };
    using ::testing::HasSubstr;
    EXPECT_THAT(refusal("morphology.area_fraction=0.9"),
                ::testing::AllOf(HasSubstr("morphology.area_fraction = 0.9"),
                                 HasSubstr("jammed at an area fraction of 0.7")));
    EXPECT_THAT(refusal("morphology.area_fraction="), HasSubstr("area_fraction is missing"));
    EXPECT_THAT(refusal("morphology.smallest_gap="), HasSubstr("smallest_gap is missing"));
    EXPECT_THAT(refusal("morphology.discs="), HasSubstr("discs is missing; give [{ radius"));
    EXPECT_THAT(refusal("morphology.discs=[{radius='9 um'}]"), HasSubstr("[0].count is missing"));
    EXPECT_THAT(refusal("morphology.discs=[{radius='9 um',count=2000},{radius='8 um',count=1}]"),
                HasSubstr("asks for more than 2000 discs"));
    EXPECT_THAT(refusal("morphology.count=40"),
                HasSubstr("discs[0].count is not a key of a scene; known: radius, share"));
    EXPECT_THAT(refusal("morphology.seed=-1"), HasSubstr("seed = -1 is outside the limits"));
    EXPECT_THAT(refusal("morphology.file=a.csv"), HasSubstr("file is not a key"));
}

}  // namespace
}  // namespace crawford
