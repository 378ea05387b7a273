/// What to model: plain data, nothing computed.
/// read_scene.hpp fills it from TOML; a case may fill it by hand.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/linear_solvers/linear_solver.hpp"
#include "solver/packing/discs.hpp"
#include "solver/scene/material.hpp"

namespace crawford {

struct Domain {
    double width = 240e-6;      ///< period in x [m]
    double depth = 480e-6;      ///< height of the window below the surface, Ly [m]
    int nx = 64;                ///< cells across the whole width; 1 for a slab
    int ny = 96;                ///< cells over the depth
    double clustering = 2.0;    ///< c of paper eq. 32; 0 is uniform
    double clustering_x = 0.0;  ///< columns at a strip's sides are 2^-c of the mean; 0 is even
    bool half = false;          ///< model 0 <= x <= width/2 of a symmetric scene, with nx/2 columns
};

struct Uniform {};  ///< one material everywhere

struct Sandwich {  ///< a strip of the second material about x = 0
    double strip;  ///< width of the strip [m]
};

using Shape = std::variant<Uniform, Sandwich, Discs>;

enum class Indicator {
    laboratory,    ///< Phi0(x): the shape stays where it is and the solid moves through it
    reference_map  ///< Phi0(xi): each material point stays what it is
};

/// Where which material is. The first is what burns around a strip or fills the discs (AP), the
/// second is the strip or the matrix (binder); a uniform scene has only the first.
struct Morphology {
    Shape shape = Uniform{};
    std::vector<Material> materials = {ammonium_perchlorate()};
    Indicator indicator = Indicator::laboratory;
};

enum class Regression {
    pyrolysis,  ///< r_b = A exp(-Ea/(R T_s))
    fixed,      ///< r_b prescribed
    none        ///< the surface stays
};

struct Physics {
    bool heat = true;
    bool mechanics = true;
    bool reference_map = true;
    Regression regression = Regression::pyrolysis;
};

enum class Traction {
    normal,   ///< sigma.n = -p_c n: a pressure
    vertical  ///< (0, -p_c) per unit x, the paper's
};

/// The flame swings: the flux into every material times 1 + amplitude cos(2 pi frequency t).
struct FluxModulation {
    double amplitude = 0.0;
    double frequency = 0.0;  ///< [Hz]
};

/// The surface at the start: phi = amplitude cos(2 pi waves x/width).
struct Ripple {
    double amplitude = 0.0;  ///< [m]
    int waves = 1;           ///< over the whole width
};

struct Surface {
    double pressure = 0.0;               ///< chamber pressure p_c [Pa]
    std::vector<double> heat_flux = {};  ///< Q_g of each material [W/m^2]
    double burn_rate = 0.0;              ///< r_b of Regression::fixed [m/s]
    Traction traction = Traction::normal;
    std::optional<FluxModulation> modulation = std::nullopt;  ///< steady where not given
    std::optional<Ripple> ripple = std::nullopt;              ///< level where not given
};

enum class Support {
    roller,  ///< v = 0, u free but for one node
    clamped  ///< u = v = 0
};

struct Bottom {
    double temperature = 300.0;  ///< [K]; also the temperature at the start
    Support support = Support::roller;
};

enum class Stepping {
    euler,  ///< the paper's: Crank-Nicolson for heat, forward Euler for the rest; first order
    bdf2    ///< two steps back, what is explicit extrapolated to the new time; second order
};

/// Relative error that a step may add where steps are chosen and the scene does not say.
constexpr double default_accuracy = 1e-3;
/// [s] Short against the time in which heat crosses any cell, and soon left behind.
constexpr double first_chosen_step = 1e-6;

struct Time {
    double step = 20e-6;  ///< dt [s]; of the first step where steps are chosen
    /// Relative error that a step may add, where steps are chosen by it (`step = "auto"`).
    std::optional<double> accuracy = std::nullopt;
    double end = 0.1;  ///< [s]; the latest end where until_steady is given
    /// Stop when the mean burn rate changes less than this, relative, per ms.
    std::optional<double> until_steady = std::nullopt;
    Stepping scheme = Stepping::euler;
    int mechanics_every = 1;  ///< steps of heat and surface for each of stress, velocity and map

    /// Of stress, velocity and map [s].
    double mechanics_step() const { return mechanics_every * step; }
};

enum class Element {
    bbar,  ///< mean dilatation, stress carried at the integration points: an exact projection
    q1     ///< the paper's: exact integration, stress at the centre, an approximate projection
};

enum class Coupling {
    lagged,    ///< the stress work of the last step, as the paper: stable only for g < 1
    adiabatic  ///< split: the part that follows the temperature at once is a heat capacity
};

enum class ThermalStress {
    three_alpha_bulk,  ///< beta = 3 alpha K
    alpha_bulk         ///< beta = alpha K
};

enum class HeatCapacity {
    constant_pressure,  ///< c = c_p, as the paper
    constant_volume     ///< c = c_p - beta^2 T/(rho K): the coupling term supplies the rest
};

enum class SurfaceMotion {
    burning,               ///< phi_t = -r_b sqrt(1 + phi_x^2), as the paper (eq. 9)
    burning_with_material  ///< phi_t = v - u phi_x - r_b sqrt(1 + phi_x^2)
};

enum class StrainNorm {
    frobenius,         ///< sqrt(E:E)
    largest_component  ///< max |E_ij|
};

/// How the two materials of a cut cell conduct together.
enum class CutConductivity {
    arithmetic,  ///< side by side: right for heat along an interface
    harmonic,    ///< in series: right for heat across it
    laminate     ///< in series along the normal of the interface, side by side along the interface
};

/// How stiff, in K and in mu, the two materials of a cut cell are together.
enum class CutModuli {
    arithmetic,  ///< side by side: they share a strain
    harmonic     ///< in series: they share a stress
};

/// How the surface moves and burns where two materials meet in it.
enum class Front {
    faster_side,       ///< each side burns as itself, and where they meet the side that leads rules
    mean_of_materials  ///< a node between them burns with the mean of their rates
};

struct Numerics {
    Element element = Element::bbar;
    LinearSolver solver = LinearSolver::cholmod;
    double solver_tolerance = 1e-8;  ///< relative residual an iterative solver must reach
    /// Error at which the line relaxation stops, relative to the largest temperature.
    double heat_tolerance = 1e-10;
    Coupling coupling = Coupling::adiabatic;
    ThermalStress thermal_stress = ThermalStress::three_alpha_bulk;
    ThermalStress stress_work = ThermalStress::three_alpha_bulk;  ///< beta of -beta T div v
    HeatCapacity heat_capacity = HeatCapacity::constant_pressure;
    SurfaceMotion surface_motion = SurfaceMotion::burning;
    StrainNorm strain_norm = StrainNorm::frobenius;
    CutConductivity cut_cell_conductivity = CutConductivity::laminate;
    CutModuli cut_cell_moduli = CutModuli::harmonic;
    Front front = Front::faster_side;
    /// tau [s] of a Kelvin-Voigt stress 2 mu tau dev D in the softer material; where it is not
    /// given, resolved() puts it in (defaults.hpp).
    std::optional<double> viscous_time = std::nullopt;
};

/// The corner where two materials meet at a burning surface is singular, and the velocity beside it
/// alternates from node to node. This long a Kelvin-Voigt time (r_b tau = 2 um) confines that to
/// three nodes and moves the burn rate by 0.1 %.
constexpr double viscous_time_at_a_corner = 0.5e-3;

struct Output {
    std::optional<double> snapshots_every = std::nullopt;   ///< [s]
    std::optional<double> checkpoint_every = std::nullopt;  ///< [s]
    int history_every = 1;                                  ///< steps a row
};

struct Scene {
    std::string title;
    Domain domain;
    Morphology morphology;
    Physics physics;
    Surface surface;
    Bottom bottom;
    Time time;
    Numerics numerics;
    Output output;
};

}  // namespace crawford
