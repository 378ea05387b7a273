/// One way of saying that there is no solution, for the many in which solvers do.
#pragma once

#include <stdexcept>
#include <system_error>

#include "base/errors.hpp"

namespace crawford::reference {

/// What Boost's root finders, quadratures and steppers throw, and solvers of our own, tells of their
/// insides; who asks can only change what they were asked for.
inline NumericalFailure no_solution() {
    return NumericalFailure(
        "no solution is found with these parameters; take some that are nearer to the standards");
}

/// What `solve` returns.
/// \throws InputError for std::invalid_argument, which names a parameter.
/// \throws NumericalFailure where its solvers fail.
template <class Solve>
auto solved(const Solve& solve) {
    try {
        return solve();
    } catch (const InputError&) {
        throw;
    } catch (const NumericalFailure&) {
        throw;
    } catch (const std::system_error&) {
        throw;  // the machine's: a thread or memory that was not to be had
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    } catch (const std::domain_error&) {
        throw no_solution();
    } catch (const std::runtime_error&) {
        throw no_solution();
    }
}

}  // namespace crawford::reference
