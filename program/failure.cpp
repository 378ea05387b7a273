#include "program/failure.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <ios>
#include <system_error>

#include "base/errors.hpp"
#include "base/room.hpp"
#include "program/commands.hpp"
#include "reports/figure.hpp"

namespace crawford {

Failure failure_of(const std::exception_ptr& problem) {
    // First, since a call of the file system can be what found none.
    if (is_out_of_memory(problem)) return {out_of_memory, exit_code::numbers_failed};
    try {
        std::rethrow_exception(problem);
    } catch (const InputError& error) {
        return {error.what(), exit_code::wrong_input};
    } catch (const reports::FigureFailed& error) {
        return {error.what(), exit_code::wrong_input};
    } catch (const NumericalFailure& error) {
        return {error.what(), exit_code::numbers_failed};
    } catch (const std::filesystem::filesystem_error& error) {
        return {fmt::format("cannot use {}: {}", error.path1().string(), error.code().message()),
                exit_code::wrong_input};
    } catch (const std::ios_base::failure& error) {
        return {fmt::format("a file cannot be read or written: {}", error.what()),
                exit_code::wrong_input};
    } catch (const std::exception& error) {
        return {fmt::format("internal error: {}", error.what()), exit_code::numbers_failed};
    }
}

}  // namespace crawford
