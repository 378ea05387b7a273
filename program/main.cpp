/// `crawford`: see help.hpp for what it says about itself.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "base/errors.hpp"
#include "base/room.hpp"
#include "program/command_line.hpp"
#include "program/failure.hpp"
#include "solver/scene/units.hpp"

namespace {

int obey(const crawford::CommandLine& arguments) {
    // Some libraries end badly without: udunits2 says that its units are missing.
    crawford::look_for_room(crawford::for_a_library);
    const auto wanted = crawford::read_command_line(arguments);
    int code = crawford::exit_code::done;
    if (const auto* action = std::get_if<crawford::Action>(&wanted)) {
        crawford::prepare_units();
        code = (*action)();
    } else {
        std::cout << std::get<crawford::Answer>(wanted).text;
    }
    if (!std::cout.flush())
        throw crawford::InputError("cannot write to standard output; is the disk full?");
    return code;
}

/// Where memory is so short that it cannot even be tidied up (destructors of JSON ask for some) the
/// end is one line and a code of its own, as elsewhere. Any other such end is a mistake of ours.
[[noreturn]] void end_at_once() {
    const auto problem = std::current_exception();
    if (!problem || !crawford::is_out_of_memory(problem)) {
        __gnu_cxx::__verbose_terminate_handler();  // says what it was
        std::abort();
    }
    std::fprintf(stderr, "crawford: %s\n", crawford::out_of_memory);
    std::_Exit(crawford::exit_code::numbers_failed);
}

}  // namespace

int main(int count, char** arguments) {
    std::set_terminate(end_at_once);
    try {
        return obey({arguments, arguments + count});
    } catch (...) {
        const auto failure = crawford::failure_of(std::current_exception());
        std::cerr << "crawford: " << failure.message << '\n';
        // Where memory is short threads of OpenBLAS try for ever to get some, and the end of the
        // program would wait for them.
        if (crawford::is_out_of_memory(std::current_exception())) {
            std::cout.flush();
            std::_Exit(failure.exit_code);
        }
        return failure.exit_code;
    }
}
