#include "solver/projection/projection.hpp"

#include "solver/mesh/node_lengths.hpp"
#include "solver/projection/support.hpp"
#include "solver/scene/defaults.hpp"

namespace crawford {

namespace {

/// s - p I at one point of a cell, with the viscous part of the deviator where there is one.
Eigen::Matrix2d stress_at(const Deviator& s, double pressure, double viscosity,
                          const Eigen::Matrix2d& velocity_gradient) {
    Eigen::Matrix2d sigma;
    sigma << s.s11 - pressure, s.s12, s.s12, s.s22 - pressure;
    if (viscosity == 0.0) return sigma;
    const Eigen::Matrix2d d = 0.5 * (velocity_gradient + velocity_gradient.transpose());
    return sigma + 2.0 * viscosity * (d - d.trace() / 3.0 * Eigen::Matrix2d::Identity());
}

/// Conjugate gradients are left the paper's matrix.
bool condenses(LinearSolver solver) {
    return solver != LinearSolver::pcg;
}

}  // namespace

Projection::Projection(const Scene& scene, const Grid& grid, const MaterialMap& materials,
                       const Checkerboard& checkerboard, const ProjectionSources& sources)
    : grid_(grid),
      materials_(materials),
      checkerboard_(checkerboard),
      body_force_(sources.body_force),
      traction_(sources.traction),
      element_(scene.numerics.element),
      load_(scene.surface),
      solver_kind_(scene.numerics.solver),
      solver_tolerance_(scene.numerics.solver_tolerance),
      viscous_time_(viscous_time(scene)),
      matrix_(grid, held_unknowns(grid, scene.bottom.support), checkerboard.patches(),
              condenses(scene.numerics.solver)),
      in_patch_(grid.cell_columns(), grid.rows(), 0) {
    if (condenses(solver_kind_)) centres_.resize(checkerboard.patches().size());
    for (const Patch& patch : checkerboard.patches())
        for (const int a : {0, 1})
            for (const int b : {0, 1}) in_patch_(patch.i + a, patch.j + b) = 1;
    forget();
}

void Projection::forget() {
    solver_ = make_spd_solver(solver_kind_, solver_tolerance_);
}

double Projection::viscosity(int i, int j) const {
    if (viscous_time_ == 0.0) return 0.0;
    const bool first_is_softer =
        materials_.first().shear_modulus < materials_.second().shear_modulus;
    const double fraction = materials_.fraction()(i, j);
    const double softer = first_is_softer ? fraction : 1.0 - fraction;
    return softer * viscous_time_ * materials_.shear_modulus(i, j);
}

int Projection::solve(StressField& stress, const SurfaceField& surface, double time, double dt,
                      NodeVectors& velocity) {
    checkerboard_.remove_from(stress.pressure);
    assemble(surface, dt);
    const Eigen::VectorXd force = balance(stress, nullptr, surface, time).sum / dt;
    Eigen::Map<Eigen::VectorXd> flat(velocity.values().front().data(), matrix_.unknowns());
    Eigen::VectorXd v = flat;
    const int iterations = solve_condensed(force, v);
    flat = v;
    return iterations;
}

double Projection::residual(const StressField& stress, const NodeVectors& velocity,
                            const SurfaceField& surface, double time) const {
    const Balance forces = balance(stress, &velocity, surface, time);
    const double magnitude = forces.magnitude.norm();
    return magnitude == 0.0 ? 0.0 : forces.sum.norm() / magnitude;
}

void Projection::assemble(const SurfaceField& surface, double dt) {
    matrix_.clear();
    add_cells(surface, dt);
    add_patches(surface, dt);
}

ElementMatrix Projection::cell_matrix(const SurfaceField& surface, int i, int j, double dt) const {
    const Moduli moduli{materials_.bulk_modulus(i, j),
                        materials_.shear_modulus(i, j) + viscosity(i, j) / dt};
    return stiffness(element_, Cell(grid_, surface, i, j), moduli);
}

/// Cells that belong to no patch.
void Projection::add_cells(const SurfaceField& surface, double dt) {
    size_t block = 0;
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j, ++block)
            if (!in_patch_(i, j)) matrix_.add(block, cell_matrix(surface, i, j, dt));
}

void Projection::add_patches(const SurfaceField& surface, double dt) {
    size_t block = size_t(grid_.cell_columns()) * size_t(grid_.rows());
    for (size_t k = 0; k < checkerboard_.patches().size(); ++k) {
        PatchMatrix matrix = patch_matrix(surface, checkerboard_.patches()[k], dt);
        if (!centres_.empty()) centres_[k] = PatchCentre(matrix);
        matrix_.add(block++, matrix);
    }
}

/// A dilatation that alternates over a patch meets no bulk modulus: K (theta, theta) loses its part
/// along the checkerboard.
PatchMatrix Projection::patch_matrix(const SurfaceField& surface, const Patch& patch,
                                     double dt) const {
    PatchMatrix sum = PatchMatrix::Zero();
    for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
            const ElementMatrix cell = cell_matrix(surface, patch.i + a, patch.j + b, dt);
            // The corners of a cell, two and two, are neighbours in the patch's rows of three.
            for (int p = 0; p < 2; ++p)
                for (int q = 0; q < 2; ++q)
                    sum.block<4, 4>(2 * (a + 3 * (b + p)), 2 * (a + 3 * (b + q))) +=
                        cell.block<4, 4>(4 * p, 4 * q);
        }
    if (!checkerboard_.is_one_material(patch)) return sum;
    const PatchVector force = checkerboard_.unit_force(patch, surface);
    const double stiffness = materials_.bulk_modulus(patch.i, patch.j) / checkerboard_.area(patch);
    sum.noalias() -= (stiffness * force) * force.transpose();
    return sum;
}

/// Solves for all velocities: those of the centres follow from what is around them.
int Projection::solve_condensed(Eigen::VectorXd force, Eigen::VectorXd& v) {
    for (size_t k = 0; k < centres_.size(); ++k) {
        const auto nodes = patch_nodes(grid_, checkerboard_.patches()[k]);
        const PatchVector spread = centres_[k].spread(at(force, nodes[4]));
        for (size_t node = 0; node < nodes.size(); ++node)
            for (int c = 0; c < 2; ++c) {
                const int unknown = matrix_.unknown(nodes[node], c);
                if (!matrix_.held(unknown)) force[unknown] += spread[2 * int(node) + c];
            }
    }
    Eigen::VectorXd solution = matrix_.gathered(v);
    const int iterations = solver_->solve(matrix_.lower(), matrix_.gathered(force), solution);
    matrix_.scatter(solution, v);
    for (size_t k = 0; k < centres_.size(); ++k) {
        const auto nodes = patch_nodes(grid_, checkerboard_.patches()[k]);
        PatchVector around;
        for (size_t node = 0; node < nodes.size(); ++node)
            around.segment<2>(2 * int(node)) = at(v, nodes[node]);
        v.segment<2>(matrix_.unknown(nodes[4], 0)) =
            centres_[k].velocity(at(force, nodes[4]), around);
    }
    return iterations;
}

Projection::Balance Projection::balance(const StressField& stress, const NodeVectors* velocity,
                                        const SurfaceField& surface, double time) const {
    Balance forces{Eigen::VectorXd::Zero(matrix_.unknowns()),
                   Eigen::VectorXd::Zero(matrix_.unknowns())};
    add_stress(forces, stress, velocity, surface);
    add_traction(forces, surface);
    if (body_force_) add_body_force(forces, surface, time);
    if (traction_) add_traction_source(forces, surface, time);
    for (int k = 0; k < matrix_.unknowns(); ++k)
        if (matrix_.held(k)) forces.sum[k] = forces.magnitude[k] = 0.0;
    return forces;
}

/// - integral of grad w . sigma   (paper eq. 40)
void Projection::add_stress(Balance& forces, const StressField& stress, const NodeVectors* velocity,
                            const SurfaceField& surface) const {
    const auto& points = stress_points(element_);
    const double weight = 1.0 / double(points.size());
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j) {
            const Cell cell(grid_, surface, i, j);
            const auto nodes = corners(grid_, i, j);
            const double tau_mu = velocity ? viscosity(i, j) : 0.0;
            std::array<Vector, 4> sum{Vector::Zero(), Vector::Zero(), Vector::Zero(),
                                      Vector::Zero()};
            std::array<Vector, 4> magnitude = sum;
            for (size_t k = 0; k < points.size(); ++k) {
                Eigen::Matrix2d grad_v = Eigen::Matrix2d::Zero();
                if (tau_mu != 0.0) grad_v = gradient(cell, gather(*velocity, nodes), points[k]);
                const Eigen::Matrix2d sigma =
                    stress_at(stress.deviator[k](i, j), stress.pressure(i, j), tau_mu, grad_v);
                const auto hats = hat_gradients(cell, points[k]);
                for (size_t corner = 0; corner < 4; ++corner) {
                    const Vector force = -weight * cell.area() * (sigma * hats[corner]);
                    sum[corner] += force;
                    magnitude[corner] += force.cwiseAbs();
                }
            }
            for (size_t corner = 0; corner < 4; ++corner) {
                const int first = matrix_.unknown(nodes[corner], 0);
                forces.sum.segment<2>(first) += sum[corner];
                forces.magnitude.segment<2>(first) += magnitude[corner];
            }
        }
}

/// + integral of w sigma_bc . n over the surface: -p_c n ds, n ds = (-phi_x, 1) dx, or (0, -p_c)
/// dx.
///
/// The bottom of the window slopes like the surface. It is held upward only on rollers, so the same
/// pressure must meet it sideways, or what is pressed all around would be pushed along its slope;
/// the paper's traction leaves this out.
void Projection::add_traction(Balance& forces, const SurfaceField& surface) const {
    const int top = grid_.rows();
    for (int i = 0; i < grid_.cell_columns(); ++i) {
        const double half = 0.5 * grid_.dx(i) * load_.pressure;
        const double tilt = load_.traction == Traction::normal ? grid_.slope(surface, i) : 0.0;
        for (const int node : {i, grid_.right_node(i)}) {
            forces.add(matrix_.unknown({node, top}, 0), half * tilt);
            forces.add(matrix_.unknown({node, top}, 1), -half);
            forces.add(matrix_.unknown({node, 0}, 0), -half * tilt);
        }
    }
}

void Projection::add_body_force(Balance& forces, const SurfaceField& surface, double time) const {
    const NodeField areas = node_areas(grid_);
    for (int i = 0; i < areas.columns(); ++i)
        for (int j = 0; j < areas.rows(); ++j) {
            const double y = surface[size_t(i)] + grid_.eta(j);
            const Vector force = areas(i, j) * body_force_(grid_.x(i), y, time);
            for (int c = 0; c < 2; ++c) forces.add(matrix_.unknown({i, j}, c), force[c]);
        }
}

void Projection::add_traction_source(Balance& forces, const SurfaceField& surface,
                                     double time) const {
    const SurfaceField lengths = node_lengths(grid_, surface);
    for (int i = 0; i < grid_.node_columns(); ++i) {
        const Vector force = lengths[size_t(i)] * traction_(grid_.x(i), surface[size_t(i)], time);
        for (int c = 0; c < 2; ++c) forces.add(matrix_.unknown({i, grid_.rows()}, c), force[c]);
    }
}

}  // namespace crawford
