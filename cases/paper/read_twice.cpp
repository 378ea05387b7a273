#include "cases/paper/read_twice.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "cases/units.hpp"
#include "reports/norm.hpp"
#include "reports/order.hpp"

namespace crawford {

namespace {

using reports::Convergence;
using reports::Level;

/// The finer indices whose mean is bilinear interpolation at coarse index i.
struct Pair {
    int low, high;
};
Pair finer(int i, int ratio, bool at_nodes) {
    if (at_nodes || ratio == 1) return {ratio * i, ratio * i};
    return {ratio * i + ratio / 2 - 1, ratio * i + ratio / 2};
}

std::string order_of(const std::string& set, const std::string& quantity) {
    return fmt::format("{}, {}: order ", set, quantity);
}

/// What a fit over these grids reads in the paper's way if the order is p.
double biased_fit(double p, std::vector<Level> levels, double finest_h) {
    for (Level& level : levels) level.error = std::pow(level.h, p) - std::pow(finest_h, p);
    return Convergence(levels).fit();
}

}  // namespace

std::string order_in_papers_way(const std::string& set, const std::string& quantity) {
    return order_of(set, quantity) + "in the paper's way";
}

std::string order_from_differences(const std::string& set, const std::string& quantity) {
    return order_of(set, quantity) + "from successive differences";
}

reports::LedgerRow judged_order(const ledger::Evidence& evidence, const reports::Claim& claim,
                                const std::vector<std::string>& quantities, const OrderSet& set,
                                const OrderSet& other) {
    const auto found = evidence.findings_of(claim.entry);
    const auto mean = [&](const OrderSet& of, auto name) {
        double sum = 0.0;
        for (const std::string& quantity : quantities) sum += found(name(of.name, quantity));
        return sum / double(quantities.size());
    };
    const double papers_way = mean(other, order_in_papers_way);
    const std::string because = fmt::format(
        "From successive differences {:.2f}; with {} {:.2f}, {:.2f} from successive differences. "
        "The paper's way always reads too high.",
        mean(set, order_from_differences), other.with, papers_way,
        mean(other, order_from_differences));
    const std::string with = set.with.empty() ? "" : ", " + set.with;
    return reports::judged(claim, {mean(set, order_in_papers_way),
                                   {},
                                   "the paper's way: the finest grid stands for the truth" + with,
                                   {{other.with, papers_way}},
                                   because,
                                   "{:.2f}"});
}

double distance(const Lattice<double>& coarse, const Lattice<double>& fine, bool at_nodes) {
    const int extra = at_nodes ? 1 : 0;
    const int across = (fine.columns() - extra) / (coarse.columns() - extra);
    const int up = (fine.rows() - extra) / (coarse.rows() - extra);
    std::vector<double> found, truth, weight;
    for (int i = 0; i < coarse.columns(); ++i)
        for (int j = 0; j < coarse.rows(); ++j) {
            const Pair a = finer(i, across, at_nodes);
            const Pair b = finer(j, up, at_nodes);
            found.push_back(coarse(i, j));
            truth.push_back(0.25 * (fine(a.low, b.low) + fine(a.high, b.low) + fine(a.low, b.high) +
                                    fine(a.high, b.high)));
            const bool once = at_nodes && (i == 0 || i + 1 == coarse.columns());
            weight.push_back(once ? 1.0 : 2.0);
        }
    return reports::distance(reports::Norm::L2, found, truth, weight);
}

Refinement::Refinement(std::vector<Compared> quantities, double width)
    : quantities_(std::move(quantities)), width_(width) {}

void Refinement::add_grid(int nx, Fields fields) {
    nx_.push_back(nx);
    fields_.push_back(std::move(fields));
}

double Refinement::between(size_t quantity, size_t coarse, size_t fine) const {
    const Compared& what = quantities_[quantity];
    return distance(fields_[coarse][quantity], fields_[fine][quantity], what.at_nodes) / what.scale;
}

void Refinement::report(Outcome& outcome, const std::string& set) const {
    const size_t finest = nx_.size() - 1;
    std::vector<reports::Column> columns{{"dx", "um", {}}};
    for (size_t i = 0; i < finest; ++i) columns.front().values.push_back(h(i) / units::um);
    for (size_t q = 0; q < quantities_.size(); ++q) {
        const Compared& what = quantities_[q];
        reports::Column to_finest{what.name + " to finest", what.unit, {}};
        reports::Column to_next{what.name + " to next", what.unit, {}};
        std::vector<Level> papers_levels, levels;
        for (size_t i = 0; i < finest; ++i) {
            to_finest.values.push_back(between(q, i, finest));
            to_next.values.push_back(between(q, i, i + 1));
            papers_levels.push_back({nx_[i], h(i), to_finest.values.back()});
            levels.push_back({nx_[i], h(i), to_next.values.back()});
        }
        columns.push_back(to_finest);
        columns.push_back(to_next);

        const double papers = Convergence(papers_levels).fit();
        const double unbiased = reports::from_differences(levels).fit();
        outcome.figure.set(fmt::format("papers_{}_{}", set, q + 1), papers)
            .set(fmt::format("unbiased_{}_{}", set, q + 1), unbiased);
        outcome.findings.push_back({order_in_papers_way(set, what.name), papers, "-"});
        outcome.findings.push_back({order_from_differences(set, what.name), unbiased, "-"});
        if (unbiased > 0.0)  // else nothing converges that a bias could act on
            outcome.findings.push_back(
                {order_of(set, what.name) + "that this would read as in the paper's way",
                 biased_fit(unbiased, papers_levels, h(finest)), "-"});
    }
    outcome.figure.table(set, columns);
}

}  // namespace crawford
