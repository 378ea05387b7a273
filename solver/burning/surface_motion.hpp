/// The regressing surface: phi_t = -r_b sqrt(1 + phi_x^2)   (paper eq. 9, 33).
///
/// Where materials meet the burn rate jumps. There the equation has one stable (viscosity)
/// solution, in which the side that leads rules.
///
/// At the crossing the temperature has a kink, of some 40 K/um at a sandwich's notch. The first node
/// of the leading side is too cold by the kink's one flank, the straight line to the node beyond
/// too hot by the other; the middle of the two is taken. On 64 columns a sandwich's regression rate
/// is so within 0.2 % wherever its strip ends between two nodes; with either alone, 0.9 % off.
///
/// Every node moves as its own material, by Godunov's Hamiltonian on slopes taken within its own
/// material. Where an interface crosses the surface the front falls at V, the larger of the two
/// one-sided rates, each at the temperature of the crossing, and takes the first node of the side
/// that leads with it. The other side it drags along: there the front cannot lie above the plane
///     phi = phi_crossing + d sqrt((V/r)^2 - 1),
/// d the distance from the crossing, which is the fastest path down the interface and then out into
/// the slower material (a head wave). A node held by that plane needs no slope towards a crossing
/// that may be very near, so no crossing shortens the stable step.
#pragma once

#include <functional>

#include "solver/materials/surface_pieces.hpp"
#include "solver/mesh/grid.hpp"

namespace crawford {

/// A place on the surface between two node columns; of its temperature, so much is that of the
/// right one.
struct SurfacePlace {
    int left, right;
    double of_right;
};

/// r_b [m/s] that a material, by its fraction of the first, would have there.
using RateOfMaterial = std::function<double(double fraction, const SurfacePlace& place)>;

/// phi_t [m/s] of each node column.
/// \param material_velocity of the surface nodes where the surface is carried by the material too;
/// empty where it is not
/// \param dt the time in which the front comes down to where an interface drags it [s]
SurfaceField surface_rate(const Grid& grid, const SurfaceField& surface,
                          const SurfacePieces& pieces, const RateOfMaterial& rate,
                          const std::vector<Vector>& material_velocity, double dt);

/// The same where the rate of every node column is given [m/s] and nowhere jumps.
SurfaceField surface_rate(const Grid& grid, const SurfaceField& surface,
                          const SurfaceField& burn_rate,
                          const std::vector<Vector>& material_velocity);

/// r_b [m/s] of each node column: of the fastest of the pieces that are its own.
SurfaceField faster_rate(const Grid& grid, const SurfacePieces& pieces, const RateOfMaterial& rate);

/// Integral of r_b ds over integral of ds, each piece with its own rate.
double mean_over_pieces(const Grid& grid, const SurfaceField& surface, const SurfacePieces& pieces,
                        const RateOfMaterial& rate);

}  // namespace crawford
