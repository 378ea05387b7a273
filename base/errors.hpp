/// What can go wrong, by name.
/// The program turns InputError into exit code 2 and NumericalFailure into 3.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace crawford {

/// The input is wrong.
/// The message is one line that names the key, the value, the limit and what to do.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Where on a grid, for example {"cell", 0, 23} or {"node column", 5}.
struct FailurePlace {
    std::string of;
    int i = 0;
    std::optional<int> j = std::nullopt;
};

struct FailureLimit {
    double value = 0.0;
    bool is_least = false;       ///< the value had to be above it, not below
    std::string condition = "";  ///< for example "for numerics.coupling = \"lagged\""
};

/// What is known of numbers that failed. What does not apply is left empty.
struct FailureFields {
    enum class Kind {
        not_finite,             ///< the quantity is not a number
        not_positive_definite,  ///< the quantity is a matrix
        no_convergence,         ///< the quantity is what an iteration had to make small
        beyond_limit,           ///< the quantity has left its range
        told                    ///< only a message is known: it is the quantity
    };

    Kind kind = Kind::told;
    std::string module = "";    ///< what failed: an equation or the linear solver
    std::string quantity = "";  ///< what it failed at, in the words of the message
    std::optional<double> value = std::nullopt;
    std::string unit = "";  ///< of value and limit; empty for a pure number
    std::optional<FailureLimit> limit = std::nullopt;
    std::optional<FailurePlace> place = std::nullopt;
    std::optional<long> step = std::nullopt;
    std::optional<double> time = std::nullopt;  ///< at the end of that step [s]
    std::string advice = "";                    ///< what to do, or what has been done
};

/// "not finite", "no convergence", ..., as records say it.
std::string name_of(FailureFields::Kind kind);

/// The one line that tells a failure:
/// step N (t = T s): MODULE: QUANTITY = VALUE UNIT at PLACE, limit LIMIT; ADVICE
std::string in_words(const FailureFields& fields);

/// The numbers failed: a NaN, no convergence, a step beyond its limit.
/// The message is in_words of the fields.
class NumericalFailure : public std::runtime_error {
public:
    explicit NumericalFailure(FailureFields fields)
        : std::runtime_error(in_words(fields)), fields_(std::move(fields)) {}

    /// Of a failure that only its message is known of.
    explicit NumericalFailure(const std::string& told)
        : NumericalFailure(FailureFields{.quantity = told}) {}

    const FailureFields& fields() const { return fields_; }

private:
    FailureFields fields_;
};

/// The same failure where its likely cause is known: that, in place of what is advised without.
NumericalFailure because_of(const NumericalFailure& failure, const std::string& cause);

/// The same failure with one thing more to advise.
NumericalFailure with_advice(const NumericalFailure& failure, const std::string& advice);

}  // namespace crawford
