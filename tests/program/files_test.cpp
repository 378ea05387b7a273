/// What the built program does with the files and folders that it is given, and how it leaves them.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/program/program.hpp"

namespace crawford {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string one = "slab, AP, beta = 3 alpha K";

class ProgramFiles : public ProgramTest {};

/// A short burn of the slab, told to write into the test's own directory.
std::vector<std::string> short_burn(const std::string& out, std::vector<std::string> more = {}) {
    std::vector<std::string> command{
        "burn", scenes + "slab.toml", "--set", "time.end=60 us", "--quiet", "--out", out};
    command.insert(command.end(), more.begin(), more.end());
    return command;
}

TEST_F(ProgramFiles, RefusesGridsThatAStudyCannotRunOn) {
    expect_refused({"verify", "corner", "--grids", "1", "--out", out()},
                   "corner takes columns from 128 to 4096 in multiples of 128");
    for (const char* grids : {"1", "31,32", "2000000000"})
        expect_refused({"verify", "heat", "--grids", grids, "--out", out()}, "in multiples of 16");
    expect_refused({"verify", "sandwich-refinement", "--axis", "columns=3", "--out", out()},
                   "takes columns from 16 to ");
    // Its steps are an eighth of its cells.
    expect_refused({"verify", "coupled", "--axis", "cells=31,47,65", "--out", out()},
                   "in multiples of ");
    expect_refused({"verify", "heat", "--grids", "0x20", "--out", out()}, "no whole number");
    EXPECT_FALSE(fs::exists(out_));
    const Finished verify = crawford({"verify", one, "--grids", "016", "--out", out()});
    EXPECT_THAT(verify.output, HasSubstr("rows = 16")) << "decimal";
}

TEST_F(ProgramFiles, ClearsAwayTheNameOfAnOwnerThatWasKilledAsItWroteIt) {
    fs::create_directories(out_);
    const auto left = [&](const std::string& name, std::chrono::minutes ago) {
        std::ofstream(out_ / name) << "half";
        fs::last_write_time(out_ / name, fs::file_time_type::clock::now() - ago);
        return out_ / name;
    };
    const fs::path silent = left(".owner.host.7", std::chrono::minutes(10));
    const fs::path half = left("..owner.host.7.8.part", std::chrono::minutes(10));
    const fs::path new_name = left(".owner.host.9", std::chrono::minutes(0));
    ASSERT_EQ(crawford(short_burn(out())).status, 0);
    EXPECT_FALSE(fs::exists(silent));
    EXPECT_FALSE(fs::exists(half));
    EXPECT_TRUE(fs::exists(new_name)) << "its owner may be about to take the folder";
}

TEST_F(ProgramFiles, TakesOverFromAProcessThatWasKilledAndNobodyHasWaitedFor) {
    // The shell goes on as another program, which does not wait for its child.
    const std::string words =
        "echo $$ > \"$2.shell\"; \"$0\" burn \"$1\" --set time.end=\"10 s\" --quiet --out \"$2\" & "
        "echo $! > \"$2.pid\"; "
        "until [ -e \"$2/slab_history.csv\" ]; do sleep 0.05; done; kill -9 $!; exec sleep 20";
    std::thread unreaped([&] {
        run_program(
            {"timeout", "15", "sh", "-c", words, program_path(), scenes + "slab.toml", out()});
    });
    const auto pid_file = out() + ".pid";
    const Finished zombie = run_program({"sh", "-c",
                                         "until grep -q Z \"/proc/$(cat \"$0\" 2>/dev/null)/stat\" "
                                         "2>/dev/null; do sleep 0.05; done",
                                         pid_file});
    EXPECT_EQ(zombie.status, 0);
    const Finished next = crawford(short_burn(out()));
    EXPECT_EQ(next.status, 0) << next.output;
    run_program({"sh", "-c", "kill $(cat \"$0\")", out() + ".shell"});
    unreaped.join();
    for (const char* file : {".pid", ".shell"}) fs::remove(out() + file);
}

TEST_F(ProgramFiles, BurnsASceneThatComesInByAPipe) {
    const Finished piped = run_program(
        {"sh", "-c", "cat \"$1\" | \"$0\" burn - --set time.end=\"60 us\" --quiet --out \"$2\"",
         program_path(), scenes + "slab.toml", out()});
    EXPECT_EQ(piped.status, 0) << piped.output;
    EXPECT_THAT(piped.output, HasSubstr("regression rate"));
    EXPECT_TRUE(fs::exists(out_ / "scene_history.csv"));
    const Finished empty = run_program({"sh", "-c", "\"$0\" burn - < /dev/null", program_path()});
    EXPECT_EQ(empty.status, 2) << empty.output;
}

/// Typed as it lies here, not as seen from the scene.
TEST_F(ProgramFiles, TakesATableThatLiesWhereTheUserIs) {
    fs::create_directories(out_);
    fs::copy_file(scenes + "pack72.csv", out_ / "mine.csv");
    const std::string burn = "cd \"$2\" && \"$0\" burn \"$1\" --check --set morphology.file=";
    for (const auto& [file, status] : {std::pair{"mine.csv", 0}, {"pack72.csv", 0}, {"no.csv", 2}})
        EXPECT_EQ(
            run_program({"sh", "-c", burn + file, program_path(), scenes + "pack.toml", out()})
                .status,
            status)
            << file;
}

TEST_F(ProgramFiles, GoesOnFromAFailedStepWithAShorterOne) {
    const std::vector<std::string> burn{"burn",  scenes + "slab.toml",    "--quiet", "--out", out(),
                                        "--set", "output.history_every=3"};
    auto failing = burn;
    failing.insert(failing.end(), {"--set", "time.step=250 us", "--set", "time.end=10 ms"});
    EXPECT_EQ(crawford(failing).status, 3);
    std::string kept;
    for (const auto& file : fs::directory_iterator(out_))
        if (file.path().extension() == ".h5") kept = std::max(kept, file.path().string());
    auto shorter = burn;
    shorter.insert(shorter.end(),
                   {"--set", "time.step=50 us", "--set", "time.end=10 ms", "--restart", kept});
    const Finished done = crawford(shorter);
    EXPECT_EQ(done.status, 0) << done.output;
    std::ifstream history(out_ / "slab_history.csv");
    std::string line, last;
    while (std::getline(history, line)) last = line;
    EXPECT_NEAR(std::stod(last), 10e-3, 1e-9) << "the last state has its row";
}

TEST_F(ProgramFiles, RefusesAnEmptyPath) {
    expect_refused({"burn", scenes + "slab.toml", "--out", ""}, "--out: is empty");
    expect_refused({"burn", scenes + "slab.toml", "--restart", ""}, "--restart: is empty");
    expect_refused({"verify", "slab", "--junit", ""}, "--junit: is empty");
    expect_refused({"pack", scenes + "pack.toml", "--out", ""}, "--out: is empty");
    expect_refused({"verify", one, "--against", "", "--out", out()}, "--against: is empty");
}

TEST_F(ProgramFiles, SaysWhenItsAnswerCannotBeWritten) {
    const Finished full = run_program({"sh", "-c", "exec \"$0\" list > /dev/full", program_path()});
    EXPECT_EQ(full.status, 2);
    EXPECT_THAT(full.output, HasSubstr("cannot write to standard output"));
}

TEST_F(ProgramFiles, ClearsAwayItsOwnOlderResults) {
    EXPECT_EQ(crawford(short_burn(out(), {"--set", "time.end=100 us"})).status, 0);
    std::ofstream(out_ / "notes.txt") << "mine";
    std::ofstream(out_ / "notes.part") << "mine";
    std::ofstream(out_ / ".slab_checkpoint_000004.h5.0123.part") << "half, and killed";
    const Finished again = crawford(short_burn(out()));
    EXPECT_EQ(again.status, 0) << again.output;
    EXPECT_FALSE(fs::exists(out_ / "slab_000005.hdf"));
    EXPECT_FALSE(fs::exists(out_ / "slab_checkpoint_000005.h5"));
    EXPECT_TRUE(fs::exists(out_ / "slab_checkpoint_000003.h5"));
    EXPECT_TRUE(fs::exists(out_ / "notes.txt"));
    EXPECT_TRUE(fs::exists(out_ / "notes.part"));
    EXPECT_FALSE(fs::exists(out_ / ".slab_checkpoint_000004.h5.0123.part"));
    EXPECT_FALSE(fs::exists(out_ / ".owner"));
}

TEST_F(ProgramFiles, LeavesTheResultsOfAnotherSceneAlone) {
    EXPECT_EQ(crawford(short_burn(out())).status, 0);
    expect_refused({"burn", scenes + "sandwich.toml", "--out", out()},
                   "holds the results of slab, not of sandwich");
    const fs::path twin = out_ / "slab.toml";
    fs::copy_file(scenes + "slab.toml", twin);
    expect_refused({"burn", twin.string(), "--set", "surface.pressure=3 MPa", "--out", out()},
                   "surface.pressure is ");
    EXPECT_EQ(crawford(short_burn(out(), {"--set", "time.step=10 us"})).status, 0)
        << "the same file, changed, into the folder that was named";
}

/// They may be of another scene, and cannot be made again if nobody knows which.
TEST_F(ProgramFiles, LeavesAloneWhatADamagedManifestIsOf) {
    EXPECT_EQ(crawford(short_burn(out())).status, 0);
    const fs::path manifest = out_ / "manifest.json";
    const auto whole = nlohmann::json::parse(std::ifstream(manifest));
    for (const char* damaged : {"5", "null", "[]"}) {
        auto json = whole;
        json["scene"] = nlohmann::json::parse(damaged);
        std::ofstream(manifest) << json.dump();
        for (const char* how : {"--quiet", "--resume"})
            expect_refused(short_burn(out(), {how}),
                           "manifest.json is damaged: scene is no text; "
                           "name another --out, or remove what lies there");
    }
    std::ofstream(manifest) << "{ half";
    expect_refused(short_burn(out()), "manifest.json is damaged: parse error at line 1");
    EXPECT_TRUE(fs::exists(out_ / "slab_history.csv"));
    EXPECT_TRUE(fs::exists(out_ / "slab_checkpoint_000003.h5"));
}

TEST_F(ProgramFiles, SharesNoFolderWithAnotherRun) {
    EXPECT_EQ(crawford(short_burn(out())).status, 0);
    std::ofstream(out_ / ".owner") << "elsewhere 7 1\n";
    expect_refused(short_burn(out()), "is being written into by process 7 on elsewhere");
    fs::last_write_time(out_ / ".owner",
                        fs::file_time_type::clock::now() - std::chrono::minutes(3));
    EXPECT_EQ(crawford(short_burn(out())).status, 0) << "silent for three minutes";
}

TEST_F(ProgramFiles, LeavesOffInGoodOrder) {
    for (const auto& [signal, status] : {std::pair{"INT", 130}, {"TERM", 143}}) {
        fs::remove_all(out_);
        const Finished run =
            signalled(signal, "grep -q ',' " + out() + "/sandwich_history.csv",
                      {"burn", scenes + "sandwich.toml", "--quiet", "--out", out()});
        EXPECT_EQ(run.status, status) << run.output;
        const auto manifest = nlohmann::json::parse(std::ifstream(out_ / "manifest.json"));
        EXPECT_EQ(manifest.at("outcome"), "interrupted");
        const std::string checkpoint =
            fmt::format("sandwich_checkpoint_{:06d}.h5", manifest.at("last_step").get<long>());
        EXPECT_TRUE(fs::exists(out_ / checkpoint));
        EXPECT_THAT(run.output, HasSubstr("--restart " + (out_ / checkpoint).string()));
    }
}

TEST_F(ProgramFiles, KeepsWhatIsDoneOfStudies) {
    const std::string file = out() + "/records/sandwich-orders.jsonl";
    for (const auto& [signal, status] : {std::pair{"INT", 130}, {"TERM", 143}}) {
        fs::remove_all(out_);
        const Finished run = signalled(signal, "ls " + file,
                                       {"verify", "sandwich-orders", "--quiet", "--out", out()});
        EXPECT_EQ(run.status, status) << run.output;
        EXPECT_THAT(run.output, HasSubstr("verify sandwich-orders --quiet --out " + out()));
    }
}

TEST_F(ProgramFiles, RefusesANameThatIsNotUtf8) {
    fs::create_directories(out_);
    const fs::path latin = out_ / "ap\xE9.toml";
    fs::copy_file(scenes + "slab.toml", latin);
    expect_refused({"burn", latin.string(), "--out", (out_ / "burn").string()}, "is not UTF-8");
    EXPECT_FALSE(fs::exists(out_ / "burn"));
}

TEST_F(ProgramFiles, GoesOnWithValuesEqualToRounding) {
    EXPECT_EQ(crawford(short_burn(out())).status, 0);
    const Finished on =
        crawford(short_burn(out(), {"--set", "time.step=0.02 ms", "--set", "time.end=100 us",
                                    "--restart", (out_ / "slab_checkpoint_000003.h5").string()}));
    EXPECT_EQ(on.status, 0) << on.output;
    std::vector<std::string> command = short_burn(out());
    command.insert(command.begin(), "--quiet");
    EXPECT_EQ(crawford(command).status, 0) << "--quiet before the command";
}

/// The digest is looked at before HDF5 sees a byte; a directory is no file at all.
TEST_F(ProgramFiles, RefusesACheckpointThatIsNotAsItWasWritten) {
    EXPECT_EQ(crawford(short_burn(out())).status, 0);
    const fs::path checkpoint = out_ / "slab_checkpoint_000003.h5";
    std::fstream(checkpoint, std::ios::in | std::ios::out | std::ios::binary).seekp(1000) << "??";
    const std::vector<std::string> on{"--set", "time.end=100 us", "--restart"};
    const auto from = [&](const fs::path& file) {
        auto more = on;
        more.push_back(file.string());
        return short_burn(out(), more);
    };
    expect_refused(from(checkpoint), "slab_checkpoint_000003.h5 is damaged");
    expect_refused(from(out_), "cannot read");
}

/// What the program prints on stdout alone.
nlohmann::json line_of(const std::vector<std::string>& arguments, int status) {
    std::vector<std::string> command{"sh", "-c", "exec \"$@\" 2>/dev/null", "sh", program_path()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Finished run = run_program(command);
    EXPECT_EQ(run.status, status) << run.output;
    EXPECT_EQ(std::ranges::count(run.output, '\n'), 1) << run.output;
    return nlohmann::json::parse(run.output);
}

TEST_F(ProgramFiles, EndWithOneLineForPrograms) {
    const auto done = line_of(short_burn(out(), {"--json"}), 0);
    EXPECT_EQ(done.at("outcome"), "done");
    EXPECT_EQ(done.at("exit_code"), 0);
    EXPECT_EQ(done.at("out"), out());
    const auto manifest = nlohmann::json::parse(std::ifstream(out_ / "manifest.json"));
    EXPECT_EQ(done.at("results"), manifest.at("results"));
    const auto refused = line_of(short_burn(out(), {"--json", "--set", "domain.nx=many"}), 2);
    EXPECT_EQ(refused.at("outcome"), "refused");
    EXPECT_THAT(refused.at("failure").at("message").get<std::string>(), HasSubstr("domain.nx"));
}

TEST_F(ProgramFiles, AreTheSameFromAnyNumberOfThreads) {
    const std::vector<std::string> study{"verify", "stress-work", "--quiet", "--out"};
    auto alone = study, beside = study;
    alone.insert(alone.end(), {out() + "/1", "--threads", "1"});
    beside.insert(beside.end(), {out() + "/3", "--threads", "3", "--exact", "--against",
                                 out() + "/1/verify.json"});
    EXPECT_EQ(crawford(alone).status, 0);
    const Finished compared = crawford(beside);
    EXPECT_EQ(compared.status, 0) << compared.output;
    EXPECT_THAT(compared.output, HasSubstr("all the same"));
}

}  // namespace
}  // namespace crawford
