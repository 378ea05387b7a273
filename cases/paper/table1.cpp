/// # Table 1: the properties, and what follows from them
///
/// The paper prints properties of AP and binder, and two wave speeds of each. Here they stand
/// beside what the solver uses, in the printed units, and beside what follows: the speeds
/// sqrt(E/rho) and sqrt(mu/rho) of its equation 12, and the groups of its section 2.1.
///
/// - The printed wave speeds do not follow from the printed moduli and densities: they are 1.5 to 7
///   % too low. Nor would one other density put both speeds right of AP.
/// - epsilon = rho r_b^2/E is 1e-8 for the binder and less for AP, not 1e-4: quasi-statics is far
///   better justified than the paper says.
/// - The Arrhenius constant is read in m/s and the heat of reaction in kcal/kg; in the printed
///   units nothing would burn as the paper reports. The specific heat is not printed at all.
///
/// The Peclet number is of order one as the paper assumes. Its number E/(rho c_p T_0) is not, and
/// differs by 1800 between the two.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/build_info.hpp"
#include "cases/paper/ledger/evidence.hpp"
#include "cases/registry.hpp"
#include "cases/units.hpp"
#include "solver/scene/material.hpp"

namespace crawford {

namespace {

using namespace units;

constexpr double unprinted = std::numeric_limits<double>::quiet_NaN();

/// Of the paper's section 2.1.
constexpr double length = 28.0 * um;
constexpr double burn_rate = 1.0 * cm / s;
constexpr double cold = 300.0;  // [K]

double young(const Material& m) {
    return 9.0 * m.shear_modulus * m.bulk_modulus / (3.0 * m.bulk_modulus + m.shear_modulus);
}

/// Two numbers of one order of magnitude are at most this factor apart.
constexpr double order_of_magnitude = 3.2;

/// What the claims ask for.
namespace finds {
constexpr auto shear_wave = "wave speed √(μ/ρ)", longitudinal_wave = "wave speed √(E/ρ)";
constexpr auto epsilon = "ε = ρ r_b^2/E";
constexpr auto peclet = "Péclet number ρ c_p L r_b/κ";
constexpr auto stiffness = "E/(ρ c_p T_0)";
std::string of(const std::string& material, const std::string& what) {
    return material + ": " + what;
}
}  // namespace finds

struct Row {
    std::string what, unit;
    double (*of)(const Material&);  ///< in `unit`
    std::array<double, 2> printed;  ///< AP, binder; what holds for both stands twice
    double factor = 1.01;           ///< what lies further apart than this differs; 0: not printed
};

std::vector<Row> properties() {
    using M = const Material&;
    return {
        {"thermal conductivity κ",
         "W/(m K)",
         [](M m) { return m.thermal_conductivity; },
         {0.405, 0.276}},
        {"activation energy E_a/R",
         "K",
         [](M m) { return m.activation_temperature; },
         {11000, 7500}},
        {"heat of reaction q_s", "J/kg", [](M m) { return m.heat_of_reaction; }, {-47, -100}},
        {"Arrhenius constant A",
         "cm/s",
         [](M m) { return m.pyrolysis_prefactor / (cm / s); },
         {1450, 10.36}},
        {"bulk modulus K", "MPa", [](M m) { return m.bulk_modulus / MPa; }, {14950, 10670}},
        {"shear modulus μ", "MPa", [](M m) { return m.shear_modulus / MPa; }, {12500, 2.5}},
        {"density ρ", "kg/m^3", [](M m) { return m.density; }, {1950, 920}},
        {"thermal expansion α", "1/K", [](M m) { return m.thermal_expansion; }, {1e-5, 1e-4}},
        {"specific heat c_p",
         "J/(kg K)",
         [](M m) { return m.specific_heat; },
         {unprinted, unprinted},
         0.0},
    };
}

std::vector<Row> consequences() {
    using M = const Material&;
    return {
        {"Young's modulus E",
         "MPa",
         [](M m) { return young(m) / MPa; },
         {unprinted, unprinted},
         0.0},
        {finds::shear_wave,
         "m/s",
         [](M m) { return std::sqrt(m.shear_modulus / m.density); },
         {2357.4, 51.3}},
        {finds::longitudinal_wave,
         "m/s",
         [](M m) { return std::sqrt(young(m) / m.density); },
         {3669.8, 88.8}},
        {finds::epsilon,
         "-",
         [](M m) { return m.density * burn_rate * burn_rate / young(m); },
         {1e-4, 1e-4},
         order_of_magnitude},
        {finds::peclet,
         "-",
         [](M m) {
             return m.density * m.specific_heat * length * burn_rate / m.thermal_conductivity;
         },
         {1.0, 1.0},
         order_of_magnitude},
        {finds::stiffness,
         "-",
         [](M m) { return young(m) / (m.density * m.specific_heat * cold); },
         {1.0, 1.0},
         order_of_magnitude},
    };
}

/// One block of rows, as numbers in a CSV and as text for the picture.
void add(Outcome& outcome, const std::string& block, const std::vector<Row>& rows) {
    const Material ap = ammonium_perchlorate();
    const Material binder = htpb_binder();
    std::vector<reports::Column> columns{{"row", "-", {}},
                                         {"AP", "unit of the row", {}},
                                         {"AP printed", "unit of the row", {}},
                                         {"binder", "unit of the row", {}},
                                         {"binder printed", "unit of the row", {}},
                                         {"may differ by a factor of", "-", {}}};
    for (size_t k = 0; k < rows.size(); ++k) {
        const Row& row = rows[k];
        const double values[] = {double(k + 1),  row.of(ap),     row.printed[0],
                                 row.of(binder), row.printed[1], row.factor};
        for (size_t c = 0; c < columns.size(); ++c) columns[c].values.push_back(values[c]);
        outcome.figure.set(fmt::format("{}_{}", block, k + 1), row.what)
            .set(fmt::format("{}_unit_{}", block, k + 1), row.unit);
    }
    outcome.figure.table(block, columns).set(block + "_rows", double(rows.size()));
}

Outcome table1(const Request& request) {
    Outcome outcome{reports::Figure("table1", request.out), {}, {}};
    add(outcome, "properties", properties());
    add(outcome, "consequences", consequences());
    for (const Row& row : consequences()) {
        outcome.findings.push_back(
            {finds::of("AP", row.what), row.of(ammonium_perchlorate()), row.unit});
        outcome.findings.push_back(
            {finds::of("binder", row.what), row.of(htpb_binder()), row.unit});
    }
    outcome.figure
        .caption({.revision = revision(),
                  .note = fmt::format("r_b = {:g} cm/s, L = {:g} µm, T_0 = {:g} K; for the last "
                                      "three the paper states orders of magnitude",
                                      burn_rate / (cm / s), length / um, cold)})
        .panel(reports::Format::svg, {.width = 820, .height = 560});
    return outcome;
}

using Found = std::function<double(const std::string& what)>;

reports::LedgerRow wave_speed(const Found& found, const std::string& material,
                              const std::string& name, const char* what, const char* printed) {
    return reports::judged(
        {fmt::format("{} of {}", name, material), "Table 1", "table1", "m/s", printed,
         std::stod(printed), reports::half_digit(printed)},
        {found(finds::of(material, what)),
         ledger::exact,
         "eq. 12, 13 with the table's own K, mu, rho",
         {},
         "The printed speed does not follow from the printed table; nothing else "
         "depends on it.",
         "{:.1f}"});
}

/// "O(1)".
reports::LedgerRow order_one(const std::string& claim, double value, const std::string& reading) {
    return reports::judged(reports::Statement{
        claim, "sec. 2.1", "table1", "O(1)", fmt::format("{:.2g}", value), reading,
        std::abs(std::log10(value)) <= 0.5, "Within a factor of 3.2 of one counts as O(1)."});
}

ledger::Rows claims(const ledger::Evidence& evidence) {
    const auto found = evidence.findings_of("table1");
    ledger::Rows rows = {
        wave_speed(found, "AP", "shear wave speed", finds::shear_wave, "2357.4"),
        wave_speed(found, "AP", "longitudinal wave speed", finds::longitudinal_wave, "3669.8"),
        wave_speed(found, "binder", "shear wave speed", finds::shear_wave, "51.3"),
        wave_speed(found, "binder", "longitudinal wave speed", finds::longitudinal_wave, "88.8")};
    for (const std::string material : {"AP", "binder"}) {
        rows.push_back(reports::judged({"epsilon = rho r_b^2/E of " + material, "sec. 2.1",
                                        "table1", "-", "about 1e-4", 1e-4, 0.55e-4},
                                       {found(finds::of(material, finds::epsilon)),
                                        ledger::exact,
                                        "1 cm/s",
                                        {},
                                        "Quasi-statics holds all the better.",
                                        "{:.2g}"}));
        rows.push_back(order_one("Peclet number of " + material,
                                 found(finds::of(material, finds::peclet)), "L = 28 um, 1 cm/s"));
        rows.push_back(order_one("E/(rho c_p T_0) of " + material,
                                 found(finds::of(material, finds::stiffness)), "300 K"));
    }
    return rows;
}

const Registered here{{.name = "table1",
                       .figure = "Table 1",
                       .shows = "properties as used and printed, and what follows from them",
                       .physics = {physics::materials},
                       .cost = {.draft = 0.2, .paper = 0.2},
                       .draw = table1,
                       .claims = claims}};

}  // namespace

}  // namespace crawford
