#include "cases/scenes/sandwich.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/source_tree.hpp"
#include "cases/units.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford {

Scene sandwich(const std::vector<std::string>& overrides) {
    Scene scene = read_scene(source_path("cases/scenes/sandwich.toml"), overrides);
    scene.time.until_steady.reset();
    scene.output = {.checkpoint_every = 10e-3};
    return scene;
}

Scene burning_sandwich(Fidelity fidelity, bool mechanics) {
    std::vector<std::string> overrides = {fmt::format("physics.mechanics={}", mechanics),
                                          fmt::format("physics.reference_map={}", mechanics)};
    switch (fidelity) {
        case Fidelity::draft:
            overrides.insert(overrides.end(), {"domain.nx=32", "domain.ny=48", "time.step=40 us",
                                               "time.end=0.08 s"});
            break;
        case Fidelity::paper:
            overrides.insert(overrides.end(),
                             {"domain.nx=64", "domain.ny=96", "time.step=20 us", "time.end=0.1 s"});
            break;
        case Fidelity::fine:
            overrides.insert(overrides.end(), {"domain.nx=128", "domain.ny=96", "time.step=20 us",
                                               "time.end=0.1 s"});
    }
    return sandwich(overrides);
}

SurfaceLine surface_line(const Snapshot& half) {
    SurfaceLine line;
    const int n = half.position.columns() - 1;
    const int top = half.position.rows() - 1;
    for (int i = -n; i <= n; ++i) {
        const Vector& at = half.position(std::abs(i), top);
        line.x.push_back(i < 0 ? -at.x() : at.x());
        line.height.push_back(at.y());
        line.temperature.push_back(half.temperature(std::abs(i), top));
    }
    return line;
}

reports::QuadMap whole_map(const Snapshot& half, const std::string& name, const std::string& unit,
                           const Lattice<double>& field, double scale) {
    const int n = half.position.columns() - 1;
    const int rows = half.position.rows() - 1;
    const bool at_nodes = field.columns() == n + 1;
    reports::QuadMap map{.columns = size_t(2 * n),
                         .rows = size_t(rows),
                         .x = {"x", "um", {}},
                         .y = {"y", "um", {}},
                         .fields = {{name, unit, {}}}};
    for (int j = 0; j <= rows; ++j)
        for (int i = -n; i <= n; ++i) {
            const Vector at = half.position(std::abs(i), j) / units::um;
            map.x.values.push_back(i < 0 ? -at.x() : at.x());
            map.y.values.push_back(at.y());
        }
    for (int j = 0; j < field.rows(); ++j)
        for (int i = -n; i < (at_nodes ? n + 1 : n); ++i) {
            const int image = at_nodes || i >= 0 ? std::abs(i) : -i - 1;
            map.fields.front().values.push_back(field(image, j) / scale);
        }
    return map;
}

}  // namespace crawford
