#include <fmt/format.h>

#include <cmath>

#include "cases/paper/ledger/rows.hpp"
#include "cases/scenes/pack.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/units.hpp"
#include "solver/mesh/grid.hpp"

namespace crawford::ledger {

namespace {

using reports::half_digit;
using reports::judged;
using reports::OtherReading;
using reports::Statement;
using namespace units;
using Rows = std::vector<reports::LedgerRow>;

/// A closed form has neither grid nor step.
constexpr reports::Uncertainty exact{.grid = 0.0, .step = 0.0};

void add_wave_speeds(Rows& rows, const Findings& finding) {
    struct Printed {
        const char* material;
        const char* name;
        const char* what;
        const char* value;
    };
    for (const Printed& p :
         {Printed{"AP", "shear wave speed", "wave speed √(μ/ρ)", "2357.4"},
          Printed{"AP", "longitudinal wave speed", "wave speed √(E/ρ)", "3669.8"},
          Printed{"binder", "shear wave speed", "wave speed √(μ/ρ)", "51.3"},
          Printed{"binder", "longitudinal wave speed", "wave speed √(E/ρ)", "88.8"}})
        rows.push_back(
            judged({fmt::format("{} of {}", p.name, p.material), "Table 1", "table1", "m/s",
                    p.value, std::stod(p.value), half_digit(p.value)},
                   {finding("table1", fmt::format("{}: {}", p.material, p.what)),
                    exact,
                    "eq. 12, 13 with the table's own K, mu, rho",
                    {},
                    "The printed speed does not follow from the printed table; nothing else "
                    "depends on it.",
                    "{:.1f}"}));
}

void add_scales(Rows& rows, const Findings& finding) {
    for (const std::string material : {"AP", "binder"}) {
        rows.push_back(judged({"epsilon = rho r_b^2/E of " + material, "sec. 2.1", "table1", "-",
                               "about 1e-4", 1e-4, 0.55e-4},
                              {finding("table1", material + ": ε = ρ r_b^2/E"),
                               exact,
                               "1 cm/s",
                               {},
                               "Quasi-statics holds all the better.",
                               "{:.2g}"}));
        const double peclet = finding("table1", material + ": Péclet number ρ c_p L r_b/κ");
        const double stiffness = finding("table1", material + ": E/(ρ c_p T_0)");
        const auto order_one = [](double x) { return std::abs(std::log10(x)) <= 0.5; };
        rows.push_back(
            judged(Statement{"Peclet number of " + material, "sec. 2.1", "table1", "O(1)",
                             fmt::format("{:.2g}", peclet), "L = 28 um, 1 cm/s", order_one(peclet),
                             "Within a factor of 3.2 of one counts as O(1)."}));
        rows.push_back(
            judged(Statement{"E/(rho c_p T_0) of " + material, "sec. 2.1", "table1", "O(1)",
                             fmt::format("{:.2g}", stiffness), "300 K", order_one(stiffness),
                             "Within a factor of 3.2 of one counts as O(1)."}));
    }
}

void add_cells(Rows& rows) {
    const auto finest = [](const Scene& scene) {
        const Grid grid(scene.domain);
        return grid.height(grid.rows() - 1) / um;
    };
    rows.push_back(judged({"finest cell of the sandwich's grid", "sec. 5.1", "fig01", "um", "1.25",
                           1.25, half_digit("1.25")},
                          {finest(burning_sandwich(Fidelity::paper, true)),
                           exact,
                           "eq. 32, c = 2, 96 rows over 480 um",
                           {},
                           {},
                           "{:.3f}"}));
    rows.push_back(judged(
        {"finest cell of the pack's grid", "sec. 5.2", "fig01", "um", "2", 2.0, half_digit("2")},
        {finest(burning_pack(Fidelity::paper)),
         exact,
         "eq. 32, c = 2, 96 rows over 720 um",
         {},
         {},
         "{:.3f}"}));
}

void add_slab(Rows& rows, const Findings& finding) {
    const double error = finding("fig03", "error: distance to the exact solution");
    const double model = std::abs(finding("fig03", "model: distance to Kuznetsov-Stewart"));
    const double rise = finding("fig03", "surface temperature") - 300.0;
    rows.push_back(judged(Statement{
        "solver and analytical model agree for AP", "Fig. 3", "fig03", "excellent agreement",
        fmt::format("surface temperature {:.2g} K from the exact solution of the solver's own "
                    "model, {:.2g} K from the small-strain model",
                    error, model),
        "3 alpha K, q_s = 0", model < 0.01 * rise,
        "Holds to 1 % of the rise; the distance to the small-strain model is model difference, "
        "which no grid removes."}));
    const double ap = finding("fig04", "AP: colder by mechanics, 3 alpha K");
    rows.push_back(judged(Statement{
        "drop of the surface temperature of AP", "Fig. 4a", "fig04", "almost negligible",
        fmt::format("{:.2g} K (3 alpha K), {:.2g} K (alpha K)", ap,
                    finding("fig04", "AP: colder by mechanics, alpha K")),
        "q_s = 0", ap < 0.01 * rise, "Below 1 % of the rise under both readings of beta."}));
    const double binder_error = finding("fig04", "binder_three_alpha: error of it");
    rows.push_back(
        judged({"drop of the surface temperature of binder", "Fig. 4b", "fig04", "K", "about 80",
                80.0, 5.0 + 8.0},
               {finding("fig04", "binder: colder by mechanics, 3 alpha K"),
                {.grid = std::abs(binder_error), .step = 0.0},
                "3 alpha K, q_s = 0",
                {{"alpha K", finding("fig04", "binder: colder by mechanics, alpha K")}},
                "Eqs. 50-53 are written with alpha K, eq. 38 with 3 alpha K; in Kuznetsov "
                "and Stewart's small strain it is 47.5 K with alpha K.",
                "{:.1f}"}));
}

double mean_of(const Findings& finding, const std::string& entry, const std::string& set,
               const std::vector<std::string>& names, const std::string& what) {
    double sum = 0.0;
    for (const std::string& name : names)
        sum += finding(entry, fmt::format("{}, {}: {}", set, name, what));
    return sum / double(names.size());
}

const std::string papers_way = "order in the paper's way";
const std::string unbiased = "order from successive differences";

void add_order(Rows& rows, const Findings& finding, const reports::Claim& claim,
               const std::vector<std::string>& names, const std::string& set,
               const std::string& other_set) {
    const auto order = [&](const std::string& of, const std::string& way) {
        return mean_of(finding, claim.entry, of, names, way);
    };
    std::vector<OtherReading> others;
    std::string because = fmt::format("From successive differences {:.2f}", order(set, unbiased));
    if (!other_set.empty()) {
        others.push_back({"B-bar element", order(other_set, papers_way)});
        because +=
            fmt::format("; with the B-bar element {:.2f}, {:.2f} from successive differences",
                        order(other_set, papers_way), order(other_set, unbiased));
    }
    rows.push_back(judged(claim, {order(set, papers_way),
                                  {},
                                  "the paper's way: the finest grid stands for the truth" +
                                      std::string(set == "q1" ? ", q1 element" : ""),
                                  others,
                                  because + ". The paper's way always reads too high.",
                                  "{:.2f}"}));
}

void add_orders(Rows& rows, const Findings& finding) {
    const std::vector<std::string> stresses = {"sigma_11", "sigma_22", "sigma_33", "tau"};
    // An order is read to about a tenth: what one grid more or less changes.
    add_order(rows, finding,
              {"order of stress, cold sandwich (mean of four)", "Fig. 6a", "fig06", "-",
               "approximately 1.5", 1.5, 0.15},
              stresses, "q1", "bbar");
    add_order(rows, finding,
              {"order of u, cold sandwich", "Fig. 6b", "fig06", "-", "1.90", 1.9, 0.1}, {"u"}, "q1",
              "bbar");
    add_order(rows, finding,
              {"order of v, cold sandwich", "Fig. 6b", "fig06", "-", "1.35", 1.35, 0.1}, {"v"},
              "q1", "bbar");
    // "A first-order convergence": what is nearer to 1 than to 0.5 or 1.5.
    add_order(rows, finding,
              {"order of stress in dx, burning sandwich", "Fig. 9a", "fig09", "-", "first order",
               1.0, 0.25},
              stresses, "sandwich", "");
    add_order(rows, finding,
              {"order of velocity in dx, burning sandwich", "Fig. 9b", "fig09", "-", "first order",
               1.0, 0.25},
              {"u", "v"}, "sandwich", "");
    add_order(rows, finding,
              {"order of the reference map in dx, burning sandwich", "Fig. 9c", "fig09", "-",
               "first order", 1.0, 0.25},
              {"xi_1", "xi_2"}, "sandwich", "");
}

void add_morphology(Rows& rows, const Findings& finding) {
    double discs = 0.0;
    for (const char* radius : {"38.4", "28.8", "17.7"})
        discs += finding("fig12", fmt::format("discs of radius {} um", radius));
    rows.push_back(judged({"discs of the pack", "Fig. 12", "fig12", "-", "40", 40.0, 0.0},
                          {discs, exact, "printed diameters are radii", {}, {}, "{:.0f}"}));
    rows.push_back(
        judged({"area fraction of AP", "Fig. 12", "fig12", "%", "72", 72.0, half_digit("72")},
               {100.0 * finding("fig12", "area fraction of AP"),
                exact,
                "printed diameters are radii, period 774.4 um",
                {},
                "As diameters 40 discs cover 19.4 % of the window.",
                "{:.3f}"}));
}

}  // namespace

Rows rows_of_findings(const Findings& finding) {
    Rows rows;
    add_wave_speeds(rows, finding);
    add_scales(rows, finding);
    add_cells(rows);
    add_slab(rows, finding);
    add_orders(rows, finding);
    add_morphology(rows, finding);
    return rows;
}

}  // namespace crawford::ledger
