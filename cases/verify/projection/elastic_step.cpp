#include "cases/verify/projection/elastic_step.hpp"

#include "solver/projection/projection.hpp"
#include "solver/stress/stress_step.hpp"

namespace crawford {

namespace {

double pressure(const PlaneStress& s) {
    return -(s.s11 + s.s22 + s.s33) / 3.0;
}

}  // namespace

ElasticStep::ElasticStep(const Scene& scene, const std::function<double(double x)>& height,
                         const ProjectionSources& sources)
    : grid_(scene.domain), displacement_(grid_.node_columns(), grid_.rows() + 1) {
    for (int i = 0; i < grid_.node_columns(); ++i) surface_.push_back(height(grid_.x(i)));
    MaterialMap materials(scene.morphology, grid_, scene.numerics);
    materials.follow(surface_);
    const Element element = scene.numerics.element;
    const Checkerboard checkerboard(grid_, materials, element);
    stress_ = StressField(grid_.cell_columns(), grid_.rows(), int(stress_points(element).size()));

    // In a step of 1 s the velocity is the displacement.
    constexpr double start = 0.0;
    constexpr double dt = 1.0;
    Projection projection(scene, grid_, materials, checkerboard, sources);
    projection.solve(stress_, surface_, start + dt, dt, displacement_);
    StressStep(scene, grid_, materials, checkerboard).correct(stress_, surface_, displacement_, dt);
    residual_ = projection.residual(stress_, displacement_, surface_, start + dt);
}

void ElasticStep::compare_displacement(const std::string& quantity, const reference::Truth& exact,
                                       reports::Measurement& to, const Where& where) const {
    std::vector<Vector> points;
    std::vector<double> found, weight;
    for (int i = 0; i < grid_.node_columns(); ++i)
        for (int j = 0; j <= grid_.rows(); ++j) {
            const Vector at(grid_.x(i), surface_[size_t(i)] + grid_.eta(j));
            if (!where(at.x(), at.y())) continue;
            points.push_back(at);
            const Vector& displacement = displacement_(i, j);
            found.insert(found.end(), displacement.begin(), displacement.end());
            weight.insert(weight.end(), 2, node_area(i, j));
        }
    const auto truth = exact.values(points);
    to.field(quantity, found, truth.columns({"displacement_x", "displacement_y"}), weight);
}

void ElasticStep::compare_stress(const std::string& suffix, const reference::Truth& exact,
                                 reports::Measurement& to, const Where& where) const {
    std::vector<Vector> points;
    std::vector<double> all, s11, s22, s33, s12, p, area, all_areas;
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j) {
            const double phi = 0.5 * (surface_[size_t(i)] + surface_[size_t(grid_.right_node(i))]);
            const Vector at(grid_.x(i) + 0.5 * grid_.dx(),
                            phi + 0.5 * (grid_.eta(j) + grid_.eta(j + 1)));
            if (!where(at.x(), at.y())) continue;
            points.push_back(at);
            const PlaneStress found = stress_.mean(i, j);
            s11.push_back(found.s11);
            s22.push_back(found.s22);
            s33.push_back(found.s33);
            s12.push_back(found.s12);
            p.push_back(pressure(found));
            all.insert(all.end(), {found.s11, found.s22, found.s33, found.s12});
            area.push_back(grid_.dx() * grid_.height(j));
            all_areas.insert(all_areas.end(), 4, area.back());
        }
    const auto truth = exact.values(points);
    to.field("stress" + suffix, all,
             truth.columns({"stress_xx", "stress_yy", "stress_zz", "stress_xy"}), all_areas)
        .field("sigma_11" + suffix, s11, truth.column("stress_xx"), area)
        .field("sigma_22" + suffix, s22, truth.column("stress_yy"), area)
        .field("sigma_33" + suffix, s33, truth.column("stress_zz"), area)
        .field("sigma_12" + suffix, s12, truth.column("stress_xy"), area)
        .field("pressure" + suffix, p, truth.column("pressure"), area);
}

/// What a node stands for: half of each row of cells it is a corner of.
double ElasticStep::node_area(int i, int j) const {
    const double below = j > 0 ? grid_.height(j - 1) : 0.0;
    const double above = j < grid_.rows() ? grid_.height(j) : 0.0;
    const bool side = grid_.sides() == Sides::mirror && (i == 0 || i == grid_.node_columns() - 1);
    return grid_.dx() * (side ? 0.5 : 1.0) * 0.5 * (below + above);
}

}  // namespace crawford
