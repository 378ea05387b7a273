#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "base/scratch.hpp"
#include "fault.hpp"
#include "ledger.hpp"
#include "report.hpp"
#include "scratch_tree.hpp"

namespace crawford::mutants {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A directory of its own for each test.
class Mutants : public testing::Test {
protected:
    fs::path write(const fs::path& file, const std::string& text) const {
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << text;
        return root_ / file;
    }

    const Scratch scratch_;
    const fs::path root_ = scratch_.path();
};

const Fault sign{"sign", "solver/a.cpp", "a + b", "a - b", "the sign", {Judge::Kind::study, "sum"}};

template <class Act>
std::string refusal(const Act& act) {
    try {
        act();
    } catch (const std::exception& problem) {
        return problem.what();
    }
    return "";
}

TEST_F(Mutants, TableIsRead) {
    const auto faults = read_faults(write("t.toml", R"([[fault]]
name = "sign"
file = "solver/a.cpp"
from = "a + b"
to = "a - b"
breaks = "the sign"
study = "sum")"));
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].from, "a + b");
    EXPECT_EQ(faults[0].seen_by, (Judge{Judge::Kind::study, "sum"}));
}

TEST_F(Mutants, RowThatIsWrongIsRefusedByItsLine) {
    const auto refused = [&](const std::string& row) {
        return refusal([&] { read_faults(write("t.toml", "[[fault]]\n" + row)); });
    };
    const std::string sound = "name='n'\nfile='f'\nfrom='a'\nto='b'\nbreaks='x'\n";
    EXPECT_EQ(refused(sound + "study='s'\n"), "");
    EXPECT_THAT(refused(sound), HasSubstr("line 1"));
    EXPECT_THAT(refused(sound + "study='s'\ntest='t'\n"), HasSubstr("one of study and test"));
    EXPECT_THAT(refused(sound + "study='s'\nwhy='t'\n"), HasSubstr("line 8: unknown key why"));
    EXPECT_THAT(refused("name='n'\nfile='f'\nfrom='a'\nto='a'\nbreaks='x'\ntest='t'"),
                HasSubstr("changes nothing"));
    EXPECT_THAT(refused(sound + "study='s'\n[[fault]]\n" + sound + "study='s'\n"),
                HasSubstr("n stands twice"));
}

TEST_F(Mutants, FaultMustStandExactlyOnce) {
    EXPECT_EQ(with_fault("x = a + b;", sign), "x = a - b;");
    EXPECT_THAT(refusal([] { with_fault("x = a;", sign); }), HasSubstr("does not stand"));
    EXPECT_THAT(refusal([] { with_fault("a + b + a + b", sign); }), HasSubstr("more than once"));
}

class MutantsTree : public Mutants {
protected:
    MutantsTree() {
        write("src/solver/a.cpp", "a + b");
        write("src/cases/one_study.cpp", "{.studies = s}");
        write("src/cases/fig.cpp", "{.draw = d}");
        EXPECT_EQ(std::system(("git init -q " + (root_ / "src").string()).c_str()), 0);
    }
    ScratchTree copied() const { return {root_ / "src", root_ / "copy"}; }
};

TEST_F(MutantsTree, IsACopyThatFollowsTheSources) {
    write("copy/stranger.cpp", "");
    const auto before = copied().fingerprint([](const auto&) { return true; });
    EXPECT_EQ(copied().read("solver/a.cpp"), "a + b");
    EXPECT_FALSE(fs::exists(root_ / "copy/stranger.cpp"));
    EXPECT_EQ(copied().fingerprint([](const auto&) { return true; }), before);
    write("src/solver/a.cpp", "a * b");
    EXPECT_EQ(copied().read("solver/a.cpp"), "a * b");
    EXPECT_NE(copied().fingerprint([](const auto&) { return true; }), before);
}

TEST_F(MutantsTree, KnowsTheStudies) {
    EXPECT_THAT(copied().studies(), testing::ElementsAre("one-study"));
}

TEST_F(MutantsTree, HoldsAFaultAsLongAsItIsPlanted) {
    const ScratchTree tree = copied();
    {
        const ScratchTree::Planted planted(tree, sign);
        EXPECT_EQ(tree.read("solver/a.cpp"), "a - b");
    }
    EXPECT_EQ(tree.read("solver/a.cpp"), "a + b");
}

TEST_F(Mutants, LedgerRemembers) {
    const fs::path file = root_ / "findings.json";
    Ledger(file).keep("k", {.gates = {"sum: x"}, .seconds = 1.5});
    const auto found = Ledger(file).find("k");
    ASSERT_TRUE(found);
    EXPECT_THAT(found->gates, testing::ElementsAre("sum: x"));
    EXPECT_EQ(found->seconds, 1.5);
    EXPECT_FALSE(Ledger(file).find("other"));
}

TEST(MutantsReport, NamesSurvivorsAndWhatOnlyOneJudgeSees) {
    const Judge sum{Judge::Kind::study, "sum"};
    const Judge product{Judge::Kind::study, "product"};
    Fault scale = sign;
    scale.name = "scale";
    const Verdict seen{sign, {{sum, {{"sum: |x|, L2"}, 1.0}}, {product, {}}}, ""};
    const Verdict survivor{scale, {{sum, {}}, {product, {}}}, ""};
    const auto faults = table_of_faults({seen, survivor}, false);
    EXPECT_THAT(faults, HasSubstr(R"(sum: \|x\|, L2)"));
    EXPECT_THAT(faults, HasSubstr("1 of 2 faults seen"));
    EXPECT_THAT(faults, HasSubstr("Survivors:\n\n- scale"));
    EXPECT_THAT(faults, Not(HasSubstr("Worthless")));
    EXPECT_THAT(faults, Not(HasSubstr("another than expected")));
    const Verdict elsewhere{sign, {{sum, {}}, {product, {{"product: y, L2"}, 1.0}}}, ""};
    EXPECT_THAT(table_of_faults({elsewhere}, false), HasSubstr("sign: product, not sum"));
    EXPECT_THAT(table_of_judges({seen, survivor}), HasSubstr("| product | 0    | NOTHING"));
    EXPECT_THAT(table_of_judges({seen, survivor}), HasSubstr("| sum     | 1    | sign"));
}

}  // namespace
}  // namespace crawford::mutants
