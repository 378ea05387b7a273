/// One value of a quantity that is watched while a solid burns.
#pragma once

namespace crawford {

struct Sample {
    double time;  ///< [s]
    double value;
};

}  // namespace crawford
