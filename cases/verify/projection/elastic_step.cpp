#include "cases/verify/projection/elastic_step.hpp"

#include "solver/projection/projection.hpp"
#include "solver/stress/stress_step.hpp"

namespace crawford {

namespace {

/// Values beside their truth, each with its weight.
struct Compared {
    std::vector<double> found, truth, weight;

    void add(double value, double exact, double size) {
        found.push_back(value);
        truth.push_back(exact);
        weight.push_back(size);
    }
    void report(const std::string& quantity, reports::Measurement& to) const {
        to.field(quantity, found, truth, weight);
    }
};

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

void ElasticStep::compare_displacement(const std::string& quantity, const Displacement& exact,
                                       reports::Measurement& to, const Where& where) const {
    Compared all;
    for (int i = 0; i < grid_.node_columns(); ++i)
        for (int j = 0; j <= grid_.rows(); ++j) {
            const double x = grid_.x(i);
            const double y = surface_[size_t(i)] + grid_.eta(j);
            if (!where(x, y)) continue;
            const Vector truth = exact(x, y);
            for (int c = 0; c < 2; ++c) all.add(displacement_(i, j)[c], truth[c], node_area(i, j));
        }
    all.report(quantity, to);
}

void ElasticStep::compare_stress(const std::string& suffix, const Stress& exact,
                                 reports::Measurement& to, const Where& where) const {
    Compared all, s11, s22, s33, s12, p;
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j) {
            const double x = grid_.x(i) + 0.5 * grid_.dx();
            const double phi = 0.5 * (surface_[size_t(i)] + surface_[size_t(grid_.right_node(i))]);
            const double y = phi + 0.5 * (grid_.eta(j) + grid_.eta(j + 1));
            if (!where(x, y)) continue;
            const double area = grid_.dx() * grid_.height(j);
            const PlaneStress truth = exact(x, y);
            const PlaneStress found = stress_.mean(i, j);
            s11.add(found.s11, truth.s11, area);
            s22.add(found.s22, truth.s22, area);
            s33.add(found.s33, truth.s33, area);
            s12.add(found.s12, truth.s12, area);
            p.add(pressure(found), pressure(truth), area);
            for (const auto component :
                 {&PlaneStress::s11, &PlaneStress::s22, &PlaneStress::s33, &PlaneStress::s12})
                all.add(found.*component, truth.*component, area);
        }
    all.report("stress" + suffix, to);
    s11.report("sigma_11" + suffix, to);
    s22.report("sigma_22" + suffix, to);
    s33.report("sigma_33" + suffix, to);
    s12.report("sigma_12" + suffix, to);
    p.report("pressure" + suffix, to);
}

/// What a node stands for: half of each row of cells it is a corner of.
double ElasticStep::node_area(int i, int j) const {
    const double below = j > 0 ? grid_.height(j - 1) : 0.0;
    const double above = j < grid_.rows() ? grid_.height(j) : 0.0;
    const bool side = grid_.sides() == Sides::mirror && (i == 0 || i == grid_.node_columns() - 1);
    return grid_.dx() * (side ? 0.5 : 1.0) * 0.5 * (below + above);
}

}  // namespace crawford
