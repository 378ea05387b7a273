#include "cases/explore/extreme_axes.hpp"

#include <cmath>

#include "cases/units.hpp"

namespace crawford::extreme {

using namespace units;

namespace {

struct Way {
    const char* word;
    Stepping scheme;
    Coupling coupling;
    Element element;
    ThermalStress work;
};

constexpr auto same = ThermalStress::three_alpha_bulk;
constexpr auto less = ThermalStress::alpha_bulk;

constexpr Way ways[] = {
    {"euler, adiabatic, bbar", Stepping::euler, Coupling::adiabatic, Element::bbar, same},
    {"euler, adiabatic, q1", Stepping::euler, Coupling::adiabatic, Element::q1, same},
    {"euler, adiabatic, α K", Stepping::euler, Coupling::adiabatic, Element::bbar, less},
    {"euler, lagged, bbar", Stepping::euler, Coupling::lagged, Element::bbar, same},
    {"euler, lagged, α K", Stepping::euler, Coupling::lagged, Element::bbar, less},
    {"bdf2, adiabatic, bbar", Stepping::bdf2, Coupling::adiabatic, Element::bbar, same},
    {"bdf2, adiabatic, q1", Stepping::bdf2, Coupling::adiabatic, Element::q1, same},
    {"bdf2, adiabatic, α K", Stepping::bdf2, Coupling::adiabatic, Element::bbar, less},
    {"bdf2, lagged, bbar", Stepping::bdf2, Coupling::lagged, Element::bbar, same},
    {"bdf2, lagged, α K", Stepping::bdf2, Coupling::lagged, Element::bbar, less}};

}  // namespace

ExtremeAxis flux(std::vector<double> values) {
    return {.key = "surface.heat_flux",
            .unit = "-",
            .scale = 1.0,
            .label = "heat flux over the paper's",
            .values = std::move(values),
            .put = [](Scene& scene, double times) {
                for (double& flux : scene.surface.heat_flux) flux *= times;
            }};
}

ExtremeAxis step(std::vector<double> values) {
    return {.key = "time.step",
            .unit = "us",
            .scale = us,
            .label = "time step / µs",
            .values = std::move(values),
            .put = [](Scene& scene, double step) { scene.time.step = step; }};
}

ExtremeAxis rows(std::vector<double> values) {
    return {.key = "domain.ny",
            .unit = "cells",
            .scale = 1.0,
            .label = "rows",
            .values = std::move(values),
            .put = [](Scene& scene, double rows) { scene.domain.ny = int(std::lround(rows)); }};
}

ExtremeAxis columns(std::vector<double> values) {
    return {
        .key = "domain.nx",
        .unit = "cells",
        .scale = 1.0,
        .label = "columns over the whole width",
        .values = std::move(values),
        .put = [](Scene& scene, double columns) { scene.domain.nx = int(std::lround(columns)); }};
}

ExtremeAxis depth(std::vector<double> values) {
    return {.key = "domain.depth",
            .unit = "um",
            .scale = um,
            .label = "depth of the window / µm",
            .values = std::move(values),
            .put = [](Scene& scene, double depth) { scene.domain.depth = depth; }};
}

ExtremeAxis clustering(std::vector<double> values) {
    return {.key = "domain.clustering",
            .unit = "-",
            .scale = 1.0,
            .label = "clustering of rows",
            .values = std::move(values),
            .put = [](Scene& scene, double c) { scene.domain.clustering = c; },
            .is_logarithmic = false};
}

ExtremeAxis pressure(std::vector<double> values) {
    return {.key = "surface.pressure",
            .unit = "MPa",
            .scale = MPa,
            .label = "gas pressure / MPa",
            .values = std::move(values),
            .put = [](Scene& scene, double pressure) { scene.surface.pressure = pressure; }};
}

ExtremeAxis property(double Material::*member, const std::string& key, const std::string& label,
                     std::vector<double> values) {
    return {.key = key,
            .unit = "-",
            .scale = 1.0,
            .label = label,
            .values = std::move(values),
            .put = [member](Scene& scene, double times) {
                scene.morphology.materials.back().*member *= times;
            }};
}

ExtremeAxis couplings() {
    ExtremeAxis axis{.key = "way to couple",
                     .unit = "-",
                     .scale = 1.0,
                     .label = "",
                     .values = {},
                     .put =
                         [](Scene& scene, double number) {
                             const Way& way = ways[size_t(number)];
                             scene.time.scheme = way.scheme;
                             scene.numerics.coupling = way.coupling;
                             scene.numerics.element = way.element;
                             scene.numerics.stress_work = way.work;
                         },
                     .is_logarithmic = false};
    for (const Way& way : ways) {
        axis.values.push_back(double(axis.values.size()));
        axis.words.emplace_back(way.word);
    }
    return axis;
}

}  // namespace crawford::extreme
