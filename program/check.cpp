#include "program/check.hpp"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "program/commands.hpp"
#include "solver/files/guard_json.hpp"
#include "solver/guards/predicted.hpp"

namespace crawford {

namespace {

std::string verdict(const Guard& guard) {
    switch (guard.beyond) {
        case Beyond::nothing:
            return guard.limit ? "within" : "";
        case Beyond::remark:
            return "remark: " + guard.text;
        case Beyond::refusal:
            return "refused: " + guard.text;
    }
    return "";
}

void print(const Guards& guards) {
    for (const Guard& guard : guards) {
        const std::string limit = guard.limit ? fmt::format("{:.4g}", *guard.limit) : "-";
        std::cout << fmt::format("{:<18} {:>10.4g}  limit {:>7}  {}\n", guard.name, guard.value,
                                 limit, verdict(guard));
    }
}

void print_json(const Guards& guards) {
    const nlohmann::ordered_json json = {
        {"predicted", nlohmann::ordered_json::parse(to_json(guards))},
        {"remarks", nlohmann::ordered_json::parse(remarks_to_json(guards, {}))}};
    std::cout << json.dump(2) << '\n';
}

}  // namespace

int check(const Scene& scene, bool json) {
    const Guards guards = predicted(scene);
    json ? print_json(guards) : print(guards);
    refuse(guards);
    return exit_code::done;
}

}  // namespace crawford
