/// Keys with blanks: what a message prints can be typed back.
#include "solver/scene/toml_key.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "base/errors.hpp"
#include "base/source_tree.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford {
namespace {

using testing::HasSubstr;

std::string refusal_of(const std::vector<std::string>& overrides) {
    try {
        read_scene(source_path("cases/scenes/slab.toml"), overrides);
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

TEST(TomlKey, IsQuotedWhereItMustBe) {
    EXPECT_EQ(toml_key("AP"), "AP");
    EXPECT_EQ(toml_key("heat_flux"), "heat_flux");
    EXPECT_EQ(toml_key("filled binder"), "\"filled binder\"");
    EXPECT_EQ(toml_key("a\"b"), "\"a\\\"b\"");
    EXPECT_EQ(toml_key(""), "\"\"");
}

TEST(TomlKey, IsTakenOffAPath) {
    std::string_view path = "materials.\"filled. binder\".density";
    EXPECT_EQ(take_key(path), "materials");
    EXPECT_EQ(take_key(path), "filled. binder");
    EXPECT_EQ(take_key(path), "density");
    EXPECT_EQ(path, "");
}

TEST(TomlKey, MessagesPrintWhatTomlReads) {
    EXPECT_THAT(refusal_of({"morphology.material=filled binder"}),
                HasSubstr("[materials.\"filled binder\"]"));
    const std::string missing = refusal_of({"materials.\"filled binder\".density=1 g/cm3"});
    EXPECT_THAT(missing, HasSubstr("materials.\"filled binder\".specific_heat"));
    EXPECT_THAT(refusal_of({"materials.filled binder.density=1 g/cm3"}), testing::Eq(missing))
        << "with quotes and without";
    EXPECT_THAT(refusal_of({"materials.\"filled binder\".density=1 K"}),
                HasSubstr("materials.\"filled binder\".density = \"1 K\""));
}

}  // namespace
}  // namespace crawford
