/// What Python sees of the judgement and of the truths; python/crawford/__init__.py is its face.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "reference/truth_registry.hpp"
#include "reports/order_json.hpp"
#include "reports/order_judgement.hpp"

namespace {

namespace py = pybind11;
using namespace crawford;
using Numbers = std::vector<double>;

/// What is asked of the numbers, as the options of `crawford order`.
struct Question {
    std::optional<double> expect;
    double within, scatter, size;
    std::string reason;
};

reports::OrderQuestion question_of(const Question& asked) {
    reports::OrderQuestion question{.expected = {}, .reason = asked.reason, .size = asked.size};
    if (asked.expect)
        question.expected =
            reports::expect(*asked.expect).within(asked.within).scattering(asked.scatter);
    return question;
}

/// One column, coarsest grid first.
reports::OrderTable table_of(const std::string& name, bool is_error, const Numbers& h,
                             const Numbers& values) {
    if (h.size() != values.size()) throw InputError("h and values differ in length");
    std::vector<std::size_t> order(h.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return h[a] > h[b]; });
    reports::OrderTable table{.name = "crawford",
                              .size_name = "h",
                              .sizes = {},
                              .h = {},
                              .grids = std::vector<int>(h.size()),
                              .columns = {{name, is_error, {}}}};
    std::iota(table.grids.begin(), table.grids.end(), 1);
    for (const std::size_t k : order) {
        table.h.push_back(h[k]);
        table.columns.front().values.push_back(values[k]);
    }
    table.sizes = table.h;
    return table;
}

/// The judgement as JSON, and as text.
std::pair<std::string, std::string> judged(const std::string& name, bool is_error, const Numbers& h,
                                           const Numbers& values, const Question& question) {
    const auto table = table_of(name, is_error, h, values);
    const auto column = reports::judge(table, table.columns.front(), question_of(question));
    const auto json = reports::order_json({column});
    return {json.at("quantities").at(0).dump(), reports::text(table, column)};
}

using Values = std::vector<Numbers>;  ///< a list for each field

Values values(const reference::Truth& truth, const Numbers& x, const Numbers& y, double t) {
    if (x.size() != y.size()) throw InputError("x and y differ in length");
    std::vector<Eigen::Vector2d> points;
    for (std::size_t k = 0; k < x.size(); ++k) points.emplace_back(x[k], y[k]);
    const auto found = truth.values(points, t);
    Values all;
    for (const auto& field : found.fields()) all.push_back(found.column(field.name));
    return all;
}

void add_truths(py::module_& module) {
    using reference::Field, reference::Truth, reference::TruthEntry;
    py::class_<Field>(module, "Field")
        .def_readonly("name", &Field::name)
        .def_readonly("unit", &Field::unit)
        .def_readonly("meaning", &Field::meaning);
    py::class_<Truth>(module, "Truth")
        .def(py::init([](const std::string& name, const reference::Parameters& given) {
            return reference::truth(name, given);
        }))
        .def_property_readonly("fields", &Truth::fields)
        .def("values", &values);
    module.def("truths", [] {
        std::vector<std::pair<std::string, std::string>> all;
        for (const TruthEntry& entry : reference::truths())
            all.emplace_back(entry.name, entry.description);
        return all;
    });
}

}  // namespace

PYBIND11_MODULE(engine, module) {
    module.doc() = "The compiled part of crawford: orders, gates and exact solutions.";
    py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
    py::register_exception<NumericalFailure>(module, "NumericalFailure", PyExc_ArithmeticError);
    module.def("judged", [](const std::string& name, bool is_error, const Numbers& h,
                            const Numbers& all, std::optional<double> expect, double within,
                            double scatter, double size, const std::string& reason) {
        return judged(name, is_error, h, all, {expect, within, scatter, size, reason});
    });
    add_truths(module);
}
