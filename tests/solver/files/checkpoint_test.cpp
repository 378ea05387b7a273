// A checkpoint gives back every bit of the state, to the scene that it was written for and to no
// other.
#include "solver/files/checkpoint.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <bit>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <limits>

#include "base/errors.hpp"
#include "solver/files/hdf5_file.hpp"
#include "solver/files/scene_difference.hpp"
#include "solver/files/seal.hpp"
#include "solver/scene/write_scene.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/scratch.hpp"

namespace crawford {

namespace {

const std::string scene = R"(title = "one"
[domain]
width = "0.00024 m"
nx = 64
[morphology]
discs = [
    { x = "0.0 m", y = "1.0 m" },
    { x = "2.0 m", y = "3.0 m" },
]
[time]
step = "2e-05 s"
end = "0.1 s"
[output]
history_every = 1
)";

const Provenance provenance{scene, "1.2.3", "abcdef"};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

/// Numbers no decimal text would give back: neighbours of round ones, subnormals, -0.
class Awkward {
public:
    double operator()() {
        static constexpr double special[] = {-0.0, 5e-324, 1e-310, 1.7e308, 1.0 / 3.0};
        ++count_;
        return count_ % 7 < 5 ? special[count_ % 7] * (1.0 + 1e-16 * double(count_))
                              : std::nextafter(double(count_), 1e9);
    }

private:
    size_t count_ = 0;
};

State awkward_state() {
    Awkward next;
    State state;
    state.step = 1L << 40;
    state.time = 0.1 + 0.2;
    state.surface = {next(), next(), next()};
    state.temperature = NodeField(3, 5);
    state.velocity = NodeVectors(3, 5);
    state.stress = StressField(3, 4, 4);
    state.temperature_rate = CellField(3, 4);
    state.reference_shift = NodeVectors(3, 5);
    for (double& value : state.temperature.values()) value = next();
    for (Vector& value : state.velocity.values()) value = {next(), next()};
    for (auto& point : state.stress.deviator)
        for (Deviator& value : point.values()) value = {next(), next(), next()};
    for (double& value : state.stress.pressure.values()) value = next();
    for (double& value : state.temperature_rate.values()) value = next();
    for (Vector& value : state.reference_shift.values()) value = {next(), next()};
    return state;
}

using Bits = std::vector<std::uint64_t>;

void add(Bits& bits, double value) {
    bits.push_back(std::bit_cast<std::uint64_t>(value));
}
void add(Bits& bits, const Vector& v) {
    add(bits, v.x());
    add(bits, v.y());
}
void add(Bits& bits, const Deviator& s) {
    add(bits, s.s11);
    add(bits, s.s22);
    add(bits, s.s12);
}
template <class Value>
Bits bits_of(const Lattice<Value>& field) {
    Bits bits = {std::uint64_t(field.columns()), std::uint64_t(field.rows())};
    for (const Value& value : field.values()) add(bits, value);
    return bits;
}

class OutputCheckpoint : public OutputTest {
protected:
    std::filesystem::path file() const { return directory / "c.h5"; }
    std::string refusal(const std::string& other_scene) const {
        return message_of<InputError>([&] { load_checkpoint(file(), other_scene); });
    }
};

TEST_F(OutputCheckpoint, GivesBackEveryBit) {
    const State state = awkward_state();
    save_checkpoint(file(), {state, {.window = {{0.1, 0.2}, {0.3, 1.0 / 3.0}}}}, provenance);
    const auto [back, memory] = load_checkpoint(file(), scene);
    EXPECT_EQ(back.step, state.step);
    EXPECT_EQ(back.time, state.time);
    for (size_t i = 0; i < 3; ++i)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(back.surface.at(i)),
                  std::bit_cast<std::uint64_t>(state.surface[i]));
    EXPECT_EQ(bits_of(back.temperature), bits_of(state.temperature));
    EXPECT_EQ(bits_of(back.velocity), bits_of(state.velocity));
    ASSERT_EQ(back.stress.points(), 4);
    for (size_t point = 0; point < 4; ++point)
        EXPECT_EQ(bits_of(back.stress.deviator[point]), bits_of(state.stress.deviator[point]));
    EXPECT_EQ(bits_of(back.stress.pressure), bits_of(state.stress.pressure));
    EXPECT_EQ(bits_of(back.temperature_rate), bits_of(state.temperature_rate));
    EXPECT_EQ(bits_of(back.reference_shift), bits_of(state.reference_shift));
    ASSERT_EQ(memory.window.size(), 2u);
    EXPECT_EQ(memory.window[1].time, 0.3);
    EXPECT_EQ(memory.window[1].value, 1.0 / 3.0);
}

TEST_F(OutputCheckpoint, KeepsTheStateBefore) {
    State state = awkward_state();
    State before = awkward_state();
    before.step = 7;
    before.surface = {1.0, 2.0, 3.0};
    state.previous = std::make_shared<const State>(before);
    save_checkpoint(file(), {state, {}}, provenance);
    const State back = load_checkpoint(file(), scene).state;
    ASSERT_TRUE(back.previous);
    EXPECT_EQ(back.previous->step, 7);
    EXPECT_EQ(back.previous->surface, before.surface);
    EXPECT_EQ(bits_of(back.previous->velocity), bits_of(before.velocity));
    EXPECT_EQ(bits_of(back.temperature), bits_of(state.temperature));
}

TEST_F(OutputCheckpoint, KeepsEmptyFieldsEmpty) {
    State state;
    state.surface = {0.0};
    state.temperature = NodeField(1, 5, 300.0);
    save_checkpoint(file(), {state, {}}, provenance);
    const auto [back, memory] = load_checkpoint(file(), scene);
    EXPECT_FALSE(back.temperature.empty());
    EXPECT_TRUE(back.velocity.empty());
    EXPECT_TRUE(back.stress.empty());
    EXPECT_TRUE(back.temperature_rate.empty());
    EXPECT_TRUE(back.reference_shift.empty());
    EXPECT_TRUE(memory.window.empty());
    EXPECT_FALSE(memory.choice);
}

TEST_F(OutputCheckpoint, OfAnotherSceneIsRefusedNamingWhatDiffers) {
    save_checkpoint(file(), {awkward_state(), {}}, provenance);
    const std::string columns = refusal(replaced(scene, "nx = 64", "nx = 128"));
    EXPECT_NE(columns.find("domain.nx is 64 in the checkpoint and 128 in the scene"),
              std::string::npos)
        << columns;
    const std::string disc = refusal(replaced(scene, "y = \"3.0 m\"", "y = \"3.5 m\""));
    EXPECT_NE(disc.find("morphology.discs[1].y"), std::string::npos) << disc;
    const std::string key = refusal(scene + "[bottom]\nsupport = \"clamped\"\n");
    EXPECT_NE(key.find("bottom.support is not given in the checkpoint"), std::string::npos) << key;
}

TEST_F(OutputCheckpoint, WhereADefaultWasNotGivenStillRestarts) {
    const std::string now = to_toml(testing::sandwich(16, 24));
    const std::string given = "viscous_time = \"0.0005 s\"\n";
    ASSERT_NE(now.find(given), std::string::npos) << now;
    const std::string old = replaced(now, given, "");
    EXPECT_EQ(difference(old, now), std::nullopt);
    const std::string other = replaced(now, given, "viscous_time = \"0.001 s\"\n");
    EXPECT_THAT(difference(old, other).value_or(""),
                ::testing::HasSubstr("numerics.viscous_time is '0.0005 s' in the checkpoint"));
}

TEST_F(OutputCheckpoint, AllowsAnotherEndAndOtherOutput) {
    std::string longer = replaced(scene, "end = \"0.1 s\"", "end = \"0.2 s\"\nuntil_steady = 1e-4");
    longer = replaced(longer, "history_every = 1", "history_every = 9\nsnapshots_every = \"1 s\"");
    longer = replaced(longer, "\"one\"", "\"two\"");
    EXPECT_EQ(difference(scene, longer), std::nullopt);
    EXPECT_EQ(difference(scene, replaced(scene, "2e-05", "1e-05")), std::nullopt)
        << "a run that failed may go on with shorter steps";
}

TEST_F(OutputCheckpoint, ThatIsNoneIsRefused) {
    EXPECT_THROW(load_checkpoint(directory / "missing.h5", scene), InputError);
    put(file(), "no HDF5 at all");
    EXPECT_THROW(load_checkpoint(file(), scene), InputError);
    Hdf5File::create(file()).publish();
    EXPECT_THAT(refusal(scene), ::testing::HasSubstr("is no checkpoint, or an earlier version"));
    write_sealed(file(), Hdf5File::create(file()).image());
    EXPECT_THAT(refusal(scene), ::testing::HasSubstr("is no checkpoint"));
    EXPECT_THAT(message_of<InputError>([&] { load_checkpoint(directory, scene); }),
                ::testing::HasSubstr("cannot read"));
}

TEST_F(OutputCheckpoint, CutShortIsRefused) {
    save_checkpoint(file(), {awkward_state(), {}}, provenance);
    const std::string whole = content(file());
    for (size_t size = 0; size < whole.size(); size += size < 600 ? 3 : 997) {
        put(file(), whole.substr(0, size));
        EXPECT_THAT(refusal(scene), ::testing::HasSubstr("is damaged")) << size << " bytes";
    }
    put(file(), whole + '\0');
    EXPECT_THAT(refusal(scene), ::testing::HasSubstr("is damaged")) << "one byte more";
}

TEST_F(OutputCheckpoint, WithOneBitChangedIsRefused) {
    save_checkpoint(file(), {awkward_state(), {}}, provenance);
    const std::string whole = content(file());
    for (size_t at = 0; at < whole.size(); at += at < 600 ? 1 : 101) {
        std::string damaged = whole;
        damaged[at] = char(damaged[at] ^ (1 << at % 8));
        put(file(), damaged);
        EXPECT_THAT(refusal(scene), ::testing::HasSubstr("is damaged")) << "byte " << at;
    }
    put(file(), whole);
    EXPECT_NO_THROW(load_checkpoint(file(), scene));
}

TEST_F(OutputCheckpoint, ThatCannotBeWrittenLeavesNothing) {
    put(directory / "taken", "a file");
    EXPECT_THROW(save_checkpoint(directory / "taken" / "c.h5", {awkward_state(), {}}, provenance),
                 InputError);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory), {}), 1);
}

/// A disk that is full after a few bytes, for this process alone.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    void (*handler_)(int);
    rlimit before_{};
};

TEST_F(OutputCheckpoint, OnAFullDiskLeavesTheOldOneAsItWas) {
    put(file(), "an older checkpoint");
    {
        const FullDisk full(1024);
        EXPECT_THROW(save_checkpoint(file(), {awkward_state(), {}}, provenance), InputError);
    }
    EXPECT_EQ(content(file()), "an older checkpoint");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory), {}), 1);
}

}  // namespace

}  // namespace crawford
