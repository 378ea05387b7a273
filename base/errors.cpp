#include "base/errors.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace crawford {

namespace {

using Kind = FailureFields::Kind;

std::string with_unit(double value, const std::string& unit) {
    return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string value_of(const FailureFields& fields) {
    return fields.value ? " = " + with_unit(*fields.value, fields.unit) : "";
}

std::string what_failed(const FailureFields& fields) {
    switch (fields.kind) {
        case Kind::not_finite:
            return fields.quantity + " is not a number";
        case Kind::not_positive_definite:
            return fields.quantity + " is not positive definite";
        case Kind::no_convergence:
            return "no convergence: " + fields.quantity + value_of(fields);
        case Kind::beyond_limit:
            return fields.quantity + value_of(fields);
        case Kind::told:
            return fields.quantity;
    }
    throw std::logic_error("a kind of failure without words");
}

std::string words_of(const FailurePlace& place) {
    return place.j ? fmt::format(" at {} ({}, {})", place.of, place.i, *place.j)
                   : fmt::format(" at {} {}", place.of, place.i);
}

std::string words_of(const FailureLimit& limit, const std::string& unit) {
    return fmt::format(", limit {}{}{}{}", limit.is_least ? "above " : "",
                       with_unit(limit.value, unit), limit.condition.empty() ? "" : " ",
                       limit.condition);
}

}  // namespace

std::string name_of(Kind kind) {
    switch (kind) {
        case Kind::not_finite:
            return "not finite";
        case Kind::not_positive_definite:
            return "not positive definite";
        case Kind::no_convergence:
            return "no convergence";
        case Kind::beyond_limit:
            return "beyond limit";
        case Kind::told:
            return "told";
    }
    throw std::logic_error("a kind of failure without a name");
}

std::string in_words(const FailureFields& fields) {
    std::string line;
    if (fields.step) line += fmt::format("step {} ", *fields.step);
    if (fields.time) line += fmt::format("(t = {:.6g} s)", *fields.time);
    if (!line.empty()) line += ": ";
    if (!fields.module.empty()) line += fields.module + ": ";
    line += what_failed(fields);
    if (fields.place) line += words_of(*fields.place);
    if (fields.limit) line += words_of(*fields.limit, fields.unit);
    if (!fields.advice.empty()) line += "; " + fields.advice;
    return line;
}

NumericalFailure because_of(const NumericalFailure& failure, const std::string& cause) {
    FailureFields fields = failure.fields();
    fields.advice = "likely because of " + cause;
    return NumericalFailure(std::move(fields));
}

NumericalFailure with_advice(const NumericalFailure& failure, const std::string& advice) {
    FailureFields fields = failure.fields();
    fields.advice = fields.advice.empty() ? advice : fields.advice + "; " + advice;
    return NumericalFailure(std::move(fields));
}

}  // namespace crawford
