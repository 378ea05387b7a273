/// Random numbers that are the same everywhere.
#pragma once

#include <cstdint>
#include <random>

namespace crawford {

/// The standard fixes every output of std::mt19937_64, but leaves its distributions to the library:
/// so the step from integers to doubles is taken here.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// Uniform in [0, 1): the upper 53 bits, which a double holds exactly.
    double unit() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

private:
    std::mt19937_64 engine_;
};

}  // namespace crawford
