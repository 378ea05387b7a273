#include "reports/record_store.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "base/errors.hpp"
#include "base/scratch.hpp"

namespace crawford::reports {
namespace {

namespace fs = std::filesystem;

constexpr auto experiment = "slab, AP, beta = 3 alpha K";

Setting rows(int n) {
    return Setting()
        .set("element", "bbar")
        .set("step", Amount{0.1 + 0.2, "s"})
        .set("rows", long(n));
}

Measurement found(double value) {
    return Measurement(1.0 / 3.0)
        .error("T", Norm::L2, value, 900.0)
        .value("T_s [K]", value)
        .sample("surface", {{value, 1e-310, -0.0}, {1.0, 2.0, 3.0}});
}

Record done(int n, double value) {
    return record_of(experiment, rows(n), [value](const Setting&) { return found(value); });
}

class Records : public testing::Test {
protected:
    fs::path file() const { return directory_ / record_file_name(experiment); }
    std::string text() const {
        std::ifstream in(file());
        return {std::istreambuf_iterator<char>(in), {}};
    }
    long lines() const {
        const std::string all = text();
        return std::count(all.begin(), all.end(), '\n');
    }

    const Scratch scratch_;
    const fs::path directory_ = scratch_.path() / "records";
};

TEST_F(Records, KeepEveryBit) {
    const double nasty = 0.1 + 0.2;
    RecordStore(directory_, "a").add(done(64, nasty));
    const auto record = RecordStore(directory_, "a").find(experiment, rows(64));
    ASSERT_TRUE(record);
    EXPECT_EQ(record->setting, rows(64));
    EXPECT_EQ(record->found->h(), 1.0 / 3.0);
    EXPECT_EQ(record->found->error_of("T", Norm::L2)->error, nasty);
    EXPECT_EQ(record->found->error_of("T", Norm::L2)->scale, 900.0);
    EXPECT_EQ(record->found->value_of("T_s [K]"), nasty);
    const auto sample = *record->found->sample_of("surface");
    EXPECT_EQ(sample.values[1], 1e-310);
    EXPECT_TRUE(std::signbit(sample.values[2]));
    EXPECT_EQ(sample.weights.size(), 3U);
}

TEST_F(Records, KeepWhatTheSolverSaid) {
    Record spoken = done(32, 1.0);
    spoken.said = "front_coupling crossing_y";
    RecordStore(directory_, "now").add(spoken);
    EXPECT_EQ(RecordStore(directory_, "now").find(experiment, rows(32))->said, spoken.said);
}

TEST_F(Records, SayWhatWasDone) {
    const auto stepping = [](const Setting&) {
        work_of_this_thread() = {.steps = 7, .cells = 4096, .solver_iterations = 91};
        return found(1.0);
    };
    RecordStore(directory_, "a").add(record_of(experiment, rows(64), stepping));
    EXPECT_NE(text().find("\"cells\":4096"), std::string::npos) << text();
    const auto record = RecordStore(directory_, "a").find(experiment, rows(64));
    ASSERT_TRUE(record);
    EXPECT_EQ(record->cost.work.steps, 7);
    EXPECT_EQ(record->cost.work.solver_iterations, 91);

    RecordStore(directory_, "a").add(done(32, 1.0));
    EXPECT_EQ(RecordStore(directory_, "a").find(experiment, rows(32))->cost.work.steps, 0)
        << "the work of the run before is not its own";
}

TEST_F(Records, KeepWhatIsNoNumber) {
    const double infinity = std::numeric_limits<double>::infinity();
    RecordStore store(directory_, "a");
    store.add(done(1, std::nan("")));
    store.add(done(2, -infinity));
    RecordStore again(directory_, "a");
    EXPECT_TRUE(std::isnan(*again.find(experiment, rows(1))->found->value_of("T_s [K]")));
    EXPECT_EQ(again.find(experiment, rows(2))->found->value_of("T_s [K]"), -infinity);
}

TEST_F(Records, AreKnownByTheirSetting) {
    RecordStore store(directory_, "a");
    store.add(done(64, 1.0));
    EXPECT_TRUE(store.find(experiment, rows(64)));
    EXPECT_FALSE(store.find(experiment, rows(65)));
    EXPECT_FALSE(store.find(experiment, rows(64).set("element", "q1")));
    EXPECT_FALSE(store.find("slab", rows(64)));
}

TEST_F(Records, OfAnotherProgramAreNotFoundButCanBeJudged) {
    RecordStore(directory_, "old").add(done(64, 1.0));
    RecordStore store(directory_, "new");
    EXPECT_FALSE(store.find(experiment, rows(64)));
    EXPECT_EQ(store.newest(experiment, rows(64))->fingerprint, "old");
}

TEST_F(Records, OfAnotherProgramAreSweptOutByTheFirstThatIsAdded) {
    RecordStore(directory_, "old").add(done(64, 1.0));
    RecordStore(directory_, "new").add(done(32, 1.0));
    EXPECT_EQ(lines(), 1);
    EXPECT_FALSE(RecordStore(directory_, "new").newest(experiment, rows(64)));
}

TEST_F(Records, OfAFailedRunAreNotFound) {
    RecordStore store(directory_, "a");
    store.add(record_of(experiment, rows(64),
                        [](const Setting&) -> Measurement { throw InputError("no such cell"); }));
    EXPECT_FALSE(store.find(experiment, rows(64)));
    const auto record = RecordStore(directory_, "a").newest(experiment, rows(64));
    ASSERT_TRUE(record);
    EXPECT_EQ(record->ending.kind, Ending::Kind::refused);
    EXPECT_EQ(record->ending.message, "no such cell");
}

TEST_F(Records, SayWhereNumbersFailed) {
    const FailureFields fields{.kind = FailureFields::Kind::beyond_limit,
                               .module = "heat",
                               .quantity = "coupling number g",
                               .value = 1.014,
                               .limit = FailureLimit{1.0, false, "for \"lagged\""},
                               .place = FailurePlace{"cell", 0, 23},
                               .step = 13,
                               .time = 0.00104,
                               .advice = "take \"adiabatic\""};
    RecordStore(directory_, "a")
        .add(record_of(experiment, rows(64),
                       [&](const Setting&) -> Measurement { throw NumericalFailure(fields); }));
    const auto ending = RecordStore(directory_, "a").newest(experiment, rows(64))->ending;
    EXPECT_EQ(ending.kind, Ending::Kind::failed);
    ASSERT_TRUE(ending.failure);
    EXPECT_EQ(in_words(*ending.failure), in_words(fields));
    EXPECT_EQ(ending.failure->place->j, 23);
    EXPECT_EQ(ending.message, in_words(fields));
}

TEST_F(Records, LoseATornLastLineAndNothingElse) {
    RecordStore store(directory_, "a");
    store.add(done(32, 1.0));
    store.add(done(64, 2.0));
    const std::string whole = text();
    for (const size_t missing : {1U, 2U, 40U}) {
        std::ofstream(file()) << whole.substr(0, whole.size() - missing);
        RecordStore torn(directory_, "a");
        EXPECT_TRUE(torn.find(experiment, rows(32)));
        EXPECT_FALSE(torn.find(experiment, rows(64))) << "torn by " << missing;
        torn.add(done(64, 3.0));
        RecordStore mended(directory_, "a");
        EXPECT_TRUE(mended.find(experiment, rows(32)));
        EXPECT_EQ(mended.find(experiment, rows(64))->found->value_of("T_s [K]"), 3.0);
    }
}

TEST_F(Records, SurviveWhatIsNoRecord) {
    RecordStore(directory_, "a").add(done(32, 1.0));
    std::ofstream(file(), std::ios::app) << "{\"experiment\": 7}\n[]\nnothing\n";
    RecordStore store(directory_, "a");
    EXPECT_TRUE(store.find(experiment, rows(32)));
    store.add(done(64, 1.0));
    EXPECT_EQ(lines(), 2);
}

TEST_F(Records, SayWhichFileCannotBeWritten) {
    std::ofstream(directory_) << "a file";
    try {
        RecordStore(directory_, "a").add(done(32, 1.0));
        FAIL() << "written into a file";
    } catch (const std::exception& problem) {
        EXPECT_THAT(problem.what(), testing::HasSubstr(directory_.string()));
    }
}

TEST(RecordFileName, IsReadableAndSafe) {
    EXPECT_EQ(record_file_name(experiment), "slab_AP_beta_3_alpha_K.jsonl");
    EXPECT_EQ(record_file_name("a/../b"), "a_b.jsonl");
}

TEST(Setting, NamesWhatIsNotThere) {
    const Setting at = rows(64);
    EXPECT_EQ(at.count("rows"), 64);
    EXPECT_EQ(at.word("element"), "bbar");
    EXPECT_EQ(at.text(), "element = bbar, step = 0.30000000000000004 s, rows = 64");
    EXPECT_THROW(at.count("columns"), std::invalid_argument);
    EXPECT_THROW(at.count("element"), std::invalid_argument) << "of another kind";
}

}  // namespace
}  // namespace crawford::reports
