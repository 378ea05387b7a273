/// `crawford`: see help.hpp for what it says about itself.
#include <iostream>

#include "program/command_line.hpp"
#include "program/failure.hpp"

namespace {

int obey(const crawford::CommandLine& arguments) {
    const auto wanted = crawford::read_command_line(arguments);
    if (const auto* action = std::get_if<crawford::Action>(&wanted)) return (*action)();
    std::cout << std::get<crawford::Answer>(wanted).text;
    return crawford::exit_code::done;
}

}  // namespace

int main(int count, char** arguments) {
    try {
        return obey({arguments, arguments + count});
    } catch (...) {
        const auto failure = crawford::failure_of(std::current_exception());
        std::cerr << "crawford: " << failure.message << '\n';
        return failure.exit_code;
    }
}
