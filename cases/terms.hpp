/// The terms of the model's equations, as rows of the coverage matrix: a study names those in which
/// it would see a fault.
#pragma once

#include <array>

namespace crawford::term {

inline constexpr auto heat_storage = "heat: rho c_p dT/dt";
inline constexpr auto heat_convection = "heat: convection with v - phi_t";
inline constexpr auto heat_conduction = "heat: div(kappa grad T)";
inline constexpr auto heat_interface = "heat: conduction across an interface";
inline constexpr auto stress_work = "heat: stress work -beta T div v";
inline constexpr auto gas_flux = "heat: flux Q_g through the surface";
inline constexpr auto reaction_flux = "heat: flux q_s rho r_b of pyrolysis";
inline constexpr auto elasticity = "stress: C:D";
inline constexpr auto stress_advection = "stress: advection";
inline constexpr auto jaumann_rotation = "stress: Jaumann rotation";
inline constexpr auto thermal_stress = "stress: thermal stress -beta DT/Dt";
inline constexpr auto equilibrium = "momentum: div sigma = 0";
inline constexpr auto traction = "momentum: pressure on the surface";
inline constexpr auto support = "momentum: supports and sides";
inline constexpr auto elastic_interface = "momentum: interface between two materials";
inline constexpr auto incompressibility = "momentum: K >> mu without locking";
inline constexpr auto pyrolysis = "surface: r_b = A exp(-Ea/(R T_s))";
inline constexpr auto surface_motion = "surface: phi_t = -r_b sqrt(1 + phi_x^2)";
inline constexpr auto surface_kink = "surface: kinks";
inline constexpr auto surface_jump = "surface: a burn rate that jumps";
inline constexpr auto map_advection = "map: D(xi)/Dt = 0";
inline constexpr auto deformation = "map: F = (grad xi)^-1, E = (F^T F - I)/2";
inline constexpr auto clustering = "grid: clustering";
inline constexpr auto slope = "grid: slope of the surface";
inline constexpr auto grid_motion = "grid: motion with the surface";
inline constexpr auto moving_morphology = "morphology: material that moves through the grid";
inline constexpr auto time_step = "time: order of a step";

inline constexpr std::array all{
    heat_storage,     heat_convection,   heat_conduction,   heat_interface,
    stress_work,      gas_flux,          reaction_flux,     elasticity,
    stress_advection, jaumann_rotation,  thermal_stress,    equilibrium,
    traction,         support,           elastic_interface, incompressibility,
    pyrolysis,        surface_motion,    surface_kink,      surface_jump,
    map_advection,    deformation,       clustering,        slope,
    grid_motion,      moving_morphology, time_step};

}  // namespace crawford::term
