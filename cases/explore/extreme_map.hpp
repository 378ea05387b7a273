/// A map of settings: two axes of a scene, far from the paper's, and what theory predicts over them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/setting.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// What is varied along a side of a map.
struct ExtremeAxis {
    std::string key;                          ///< of the scene where there is one
    std::string unit;                         ///< "-" of a pure number
    double scale;                             ///< the unit in SI
    std::string label;                        ///< of the picture, with its unit
    std::vector<double> values;               ///< ascending, in the unit; of words their numbers
    std::function<void(Scene&, double)> put;  ///< takes SI
    bool is_logarithmic = true;
    std::vector<std::string> words = {};  ///< where values are not numbers: the word of each
};

/// Where theory says that an answer ends.
struct ExtremeLimit {
    std::string guard;         ///< whose number it is (docs/limits.md)
    std::optional<double> at;  ///< none: the guard's own limit
    std::string title;
    bool is_least = false;  ///< the number has to be above
};

struct ExtremeMap {
    std::string name;   ///< of its panel: a letter
    std::string title;  ///< what burns, and over what
    Scene base;
    ExtremeAxis x, y;
    std::vector<ExtremeLimit> limits = {};
    std::function<void(Scene&)> finish = {};  ///< what hangs on both axes: the end, say
};

/// A setting on a map.
struct ExtremePoint {
    const ExtremeMap* map;
    double x, y;  ///< in the units of the axes

    Scene scene() const;
    reports::Setting setting() const;
};

/// All points of a map, or of a draft: the ends and the middle of x, the ends of y.
std::vector<ExtremePoint> points_of(const ExtremeMap& map, bool is_draft);

/// How far a scene is beyond the limit that theory gives: above 1 beyond, NaN where nothing can be
/// said.
double beyond(const ExtremeLimit& limit, const Scene& scene);

/// A limit as line segments, in the units of the axes.
struct Segment {
    double x1, y1, x2, y2;
};
std::vector<Segment> trace(const ExtremeMap& map, const ExtremeLimit& limit);

/// Where a value is drawn and traced: logarithms of a logarithmic axis.
double place(const ExtremeAxis& axis, double value);
double value_at(const ExtremeAxis& axis, double place);
/// Half the distance to the nearest neighbour, beyond the ends: what a picture shows.
double first_place(const ExtremeAxis& axis);
double last_place(const ExtremeAxis& axis);

}  // namespace crawford
