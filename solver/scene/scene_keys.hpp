/// The keys of a scene file that are one value each, with their limits: one list for reading and
/// for writing.
///
/// `Table` is a TomlTable, which reads, or a TomlWriter, which writes; both offer quantity, number,
/// integer, flag, text and choice. What is not one value (the morphology, fluxes by material) is in
/// read_scene.cpp and write_scene.cpp.
#pragma once

#include <array>
#include <cstddef>

#include "solver/scene/limits.hpp"
#include "solver/scene/readings.hpp"
#include "solver/scene/scene.hpp"

namespace crawford::keys {

inline constexpr Limits length{"m", 1e-9, 1.0};
inline constexpr Limits duration{"s", 1e-12, 1e3};
inline constexpr Limits heat_flux{"W/m2", 0.0, 1e10};

/// The linear solvers by the names of their table.
inline constexpr auto solver_words = [] {
    std::array<Word<LinearSolver>, linear_solvers.size()> words{};
    for (std::size_t k = 0; k < words.size(); ++k)
        words[k] = {linear_solvers[k].name, linear_solvers[k].kind};
    return words;
}();

template <class Table>
void visit(Table& table, Material& material, Need need) {
    for (const MaterialProperty& property : material_properties)
        table.quantity(property.name, material.*property.member, property.limits, need);
}

template <class Table>
void visit(Table& table, Indicator& indicator) {
    static constexpr std::array indicators{
        Word<Indicator>{"laboratory", Indicator::laboratory},
        Word<Indicator>{"reference map", Indicator::reference_map}};
    table.choice("indicator", indicator, indicators);
}

template <class Table>
void visit(Table& table, Domain& d) {
    table.quantity("width", d.width, length, Need::required);
    table.quantity("depth", d.depth, length, Need::required);
    table.integer("nx", d.nx, {1, 16384}, Need::required);
    table.integer("ny", d.ny, {4, 16384}, Need::required);
    table.number("clustering", d.clustering, {"", 0.0, 8.0});
    table.number("clustering_x", d.clustering_x, {"", 0.0, 8.0});
    table.flag("half", d.half);
}

template <class Table>
void visit(Table& table, Physics& p) {
    static constexpr std::array regressions{Word<Regression>{"pyrolysis", Regression::pyrolysis},
                                            Word<Regression>{"fixed", Regression::fixed},
                                            Word<Regression>{"none", Regression::none}};
    table.flag("heat", p.heat);
    table.flag("mechanics", p.mechanics);
    table.flag("reference_map", p.reference_map);
    table.choice("regression", p.regression, regressions);
}

template <class Table>
void visit(Table& table, Surface& s, Need pressure, Need burn_rate) {
    static constexpr std::array tractions{Word<Traction>{"normal", Traction::normal},
                                          Word<Traction>{"vertical", Traction::vertical}};
    table.quantity("pressure", s.pressure, {"Pa", 0.0, 1e10}, pressure);
    table.quantity("burn_rate", s.burn_rate, {"m/s", 0.0, 10.0}, burn_rate);
    table.choice("traction", s.traction, tractions);
}

template <class Table>
void visit(Table& table, FluxModulation& m) {
    table.number("amplitude", m.amplitude, {"", 0.0, 1.0}, Need::required);
    table.quantity("frequency", m.frequency, {"Hz", 1e-3, 1e12}, Need::required);
}

template <class Table>
void visit(Table& table, Ripple& r) {
    table.quantity("amplitude", r.amplitude, {"m", 0.0, 1.0}, Need::required);
    table.integer("waves", r.waves, {1, 4096}, Need::optional);
}

template <class Table>
void visit(Table& table, Bottom& b) {
    static constexpr std::array supports{Word<Support>{"roller", Support::roller},
                                         Word<Support>{"clamped", Support::clamped}};
    table.quantity("temperature", b.temperature, {"K", 1.0, 5000.0});
    table.choice("support", b.support, supports);
}

template <class Table>
void visit(Table& table, Time& t) {
    static constexpr std::array schemes{Word<Stepping>{"euler", Stepping::euler},
                                        Word<Stepping>{"bdf2", Stepping::bdf2}};
    bool chosen = t.accuracy.has_value();
    table.quantity_or("auto", chosen, "step", t.step, duration);
    if (chosen) {
        t.step = first_chosen_step;
        if (!t.accuracy) t.accuracy = default_accuracy;
        table.number("accuracy", t.accuracy, {"", 1e-8, 0.1});
    }
    table.quantity("end", t.end, duration, Need::required);
    table.number("until_steady", t.until_steady, {"", 1e-15, 1.0});
    table.choice("scheme", t.scheme, schemes);
    table.integer("mechanics_every", t.mechanics_every, {1, 1000}, Need::optional);
}

template <class Table>
void visit_thermal_stress(Table& table, const char* key, ThermalStress& value) {
    static constexpr std::array readings{
        Word<ThermalStress>{"3 alpha K", ThermalStress::three_alpha_bulk},
        Word<ThermalStress>{"alpha K", ThermalStress::alpha_bulk}};
    table.choice(key, value, readings);
}

/// Before the keys that it sets, which win where they are given.
template <class Table>
void visit(Table& table, Readings& readings) {
    static constexpr std::array words{Word<Readings>{"paper", Readings::paper},
                                      Word<Readings>{"consistent", Readings::consistent}};
    table.choice("readings", readings, words);
}

template <class Table>
void visit(Table& table, Numerics& n) {
    static constexpr std::array elements{Word<Element>{"bbar", Element::bbar},
                                         Word<Element>{"q1", Element::q1}};
    static constexpr std::array couplings{Word<Coupling>{"lagged", Coupling::lagged},
                                          Word<Coupling>{"adiabatic", Coupling::adiabatic}};
    static constexpr std::array capacities{
        Word<HeatCapacity>{"c_p", HeatCapacity::constant_pressure},
        Word<HeatCapacity>{"c_v", HeatCapacity::constant_volume}};
    static constexpr std::array motions{
        Word<SurfaceMotion>{"burning", SurfaceMotion::burning},
        Word<SurfaceMotion>{"burning with material", SurfaceMotion::burning_with_material}};
    static constexpr std::array norms{Word<StrainNorm>{"frobenius", StrainNorm::frobenius},
                                      Word<StrainNorm>{"largest", StrainNorm::largest_component}};
    static constexpr std::array conductivities{
        Word<CutConductivity>{"arithmetic", CutConductivity::arithmetic},
        Word<CutConductivity>{"harmonic", CutConductivity::harmonic},
        Word<CutConductivity>{"laminate", CutConductivity::laminate}};
    static constexpr std::array moduli{Word<CutModuli>{"arithmetic", CutModuli::arithmetic},
                                       Word<CutModuli>{"harmonic", CutModuli::harmonic}};
    static constexpr std::array fronts{Word<Front>{"faster side", Front::faster_side},
                                       Word<Front>{"mean of materials", Front::mean_of_materials}};
    table.choice("element", n.element, elements);
    table.choice("solver", n.solver, solver_words);
    table.number("solver_tolerance", n.solver_tolerance, {"", 1e-15, 1e-2});
    table.number("heat_tolerance", n.heat_tolerance, {"", 1e-15, 1e-2});
    table.choice("coupling", n.coupling, couplings);
    visit_thermal_stress(table, "thermal_stress", n.thermal_stress);
    visit_thermal_stress(table, "stress_work", n.stress_work);
    table.choice("heat_capacity", n.heat_capacity, capacities);
    table.choice("surface_motion", n.surface_motion, motions);
    table.choice("strain_norm", n.strain_norm, norms);
    table.choice("cut_cell_conductivity", n.cut_cell_conductivity, conductivities);
    table.choice("cut_cell_moduli", n.cut_cell_moduli, moduli);
    table.choice("front", n.front, fronts);
    table.quantity("viscous_time", n.viscous_time, {"s", 0.0, 1.0});
}

template <class Table>
void visit(Table& table, Output& o) {
    table.quantity("snapshots_every", o.snapshots_every, duration);
    table.quantity("checkpoint_every", o.checkpoint_every, duration);
    table.integer("history_every", o.history_every, {1, 1000000000}, Need::optional);
}

}  // namespace crawford::keys
