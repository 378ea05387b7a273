/// The units that cases are written in: 0.45 * cm / s, 200 * cal / (s * cm2).
#pragma once

namespace crawford::units {

inline constexpr double m = 1.0;
inline constexpr double cm = 1e-2;
inline constexpr double um = 1e-6;
inline constexpr double cm2 = cm * cm;
inline constexpr double s = 1.0;
inline constexpr double ms = 1e-3;
inline constexpr double us = 1e-6;
inline constexpr double MPa = 1e6;
inline constexpr double cal = 4.184;  ///< thermochemical calorie [J]

}  // namespace crawford::units
