/// What the program says of a burn, and what the burn is worth: each is burnt as it is asked for,
/// also where it is refused, and again much finer.
#pragma once

#include <string>

#include "solver/scene/scene.hpp"

namespace crawford {

/// Relative difference from the finer burn beyond which an answer is wrong.
inline constexpr double wrong = 0.02;

/// What a strand burner would tell, and what the program says of it.
struct Answer {
    double burnt = 0.0;                ///< [m]
    double rate = 0.0;                 ///< regression rate at the end [m/s]
    double largest_temperature = 0.0;  ///< at the end [K]
    bool burns = false;
    bool refused = false;
    std::string said;  ///< names of remarks, words of refusal and failure
};

/// Burns it in any case, also where it is refused.
Answer burn_in_any_case(const Scene& scene);

/// At least twice the columns and rows at half the step, and more where that is too coarse itself:
/// rows, depth and step by which no number of its slabs is near its limit, by the paper's scheme and
/// element. The coupling is the one that holds for any coupling number. It ends at the same time.
Scene finest(const Scene& scene);

/// What became of a setting.
struct Judged {
    Answer found;
    bool can_be_judged = false;  ///< the finest one burns
    std::string quantity = {};   ///< in which it is furthest off
    double error = 1.0;          ///< relative; 1 of what does not burn to its end
    bool misled = false;  ///< the step that it is advised to take is refused or wrong as well
};

/// Against finest(). What is not yet alight is judged by its temperature.
Judged judge(const Scene& scene);

}  // namespace crawford
