/// A strip between blocks that conduct and store heat differently, driven to its exact temperature.
#pragma once

#include "cases/verify/heat/prescribed_heat.hpp"
#include "reference/thermal_laminate.hpp"

namespace crawford {

/// Any material that conducts and stores heat so; capacity is rho c [J/(m^3 K)]. Both rho and c differ
/// from material to material: the mean of a product is not the product of means.
Material conductor(double conductivity, double capacity);

/// AP around a strip of binder a quarter of the period wide, in a window as deep as wide.
reference::TwoConductors propellant_in_heat();

/// The same geometry, the blocks of AP, the strip with so much of their conductivity and capacity.
reference::TwoConductors conductors(double conductivity, double capacity);

/// The same with the strip wider by one cell of a grid: its edges lie in the middle of a cell.
reference::TwoConductors widened(reference::TwoConductors solid, int cells);

/// The sandwich of these, driven to reference::ThermalLaminate: `cells` across, half as many up.
PrescribedHeat heated_laminate(const reference::TwoConductors& solid, int cells);

}  // namespace crawford
