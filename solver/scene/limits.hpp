/// The values a key of a scene accepts.
#pragma once

#include <string>

namespace crawford {

/// A closed interval and the unit, in udunits' spelling, of its ends and of the scene's numbers.
struct Limits {
    const char* unit;  ///< "" for a pure number
    double least;
    double most;
};

struct IntegerLimits {
    int least;
    int most;
};

/// One word of a scene and what it means, for example {"bbar", Element::bbar}.
template <class Choice>
struct Word {
    const char* word;
    Choice meaning;
};

enum class Need { required, optional };

}  // namespace crawford
