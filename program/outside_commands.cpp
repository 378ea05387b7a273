#include "program/outside_commands.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "program/command_options.hpp"
#include "program/outside_help.hpp"
#include "program/outside_options.hpp"
#include "program/points.hpp"

namespace crawford {

namespace {

void add_json(CLI::App* command, std::optional<std::filesystem::path>& file) {
    refuse_empty(command->add_option("--json", file, "Write JSON; - prints it, and nothing else"))
        ->type_name("FILE");
}

}  // namespace

struct OutsideCommands::Commands {
    OrderOptions order;
    TruthOptions truth;
    JudgeOptions judge;
    PointsOptions points;
    CLI::App* order_command = nullptr;
    CLI::App* truth_command = nullptr;
    CLI::App* judge_command = nullptr;
    CLI::App* points_command = nullptr;

    explicit Commands(CLI::App& app) {
        add_order(app);
        add_truth(app);
        add_judge(app);
        add_points(app);
    }

    void add_order(CLI::App& app) {
        order_command = app.add_subcommand("order", help::order);
        order_command->add_option("TABLE", order.table, "Table of errors or values (CSV)")
            ->required();
        order_command
            ->add_option("--dimension", order.dimension,
                         "Of the domain, where the first column counts cells: h = cells^(-1/D)")
            ->type_name("D")
            ->capture_default_str();
        order_command
            ->add_option("--quantity", order.quantities, "Only this column; may be repeated")
            ->type_name("NAME")
            ->allow_extra_args(false);
        auto* const expect =
            order_command->add_option("--expect", order.expect, "Order that each column must have")
                ->type_name("P");
        const auto of_gate = [&](CLI::Option* option) { option->type_name("X")->needs(expect); };
        of_gate(order_command->add_option("--within", order.within,
                                          "How far the fit may miss it, else 0.1"));
        of_gate(order_command->add_option("--from", order.from,
                                          "Coarsest grid of the fit, as in the first column"));
        of_gate(order_command->add_option("--to", order.to, "Finest grid of the fit, likewise"));
        of_gate(order_command->add_option(
            "--scatter", order.scatter, "How far a pairwise order may lie from the fit, else 0.2"));
        order_command
            ->add_option("--size", order.size,
                         "Size of the truth that errors are of: below 1e-12 of it is round-off")
            ->type_name("X")
            ->capture_default_str();
        add_json(order_command, order.json);
        refuse_empty(order_command->add_option("--plot", order.plot, "Draw the errors against h"))
            ->type_name("FILE.svg");
        refuse_empty(
            order_command->add_option("--junit", order.junit, "Write JUnit XML, a test a column"))
            ->type_name("FILE")
            ->needs(expect);
        add_footer(order_command, help::order_examples);
    }

    void add_truth(CLI::App& app) {
        truth_command = app.add_subcommand("truth", help::truth);
        truth_command->set_help_flag();
        truth_command->add_flag("--help,-h", truth.help,
                                "Print this help; after NAME, what there is to ask of it");
        truth_command->add_option("NAME", truth.name, "Exact solution (crawford truth --list)");
        truth_command->add_flag("--list", truth.list, "A line for each exact solution");
        truth_command->add_flag("--describe", truth.describe,
                                "Print its parameters, their limits, and its fields");
        refuse_empty(truth_command->add_option("--points", truth.points,
                                               "Table (CSV) with the columns \"x [m],y [m]\""))
            ->type_name("FILE");
        truth_command->add_option("--set", truth.set, "Set a parameter, e.g. depth=\"300 um\"")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        truth_command->add_option("--time", truth.time, "Time, e.g. \"2 ms\", else 0 s")
            ->type_name("T");
        add_footer(truth_command, help::truth_examples);
    }

    void add_judge(CLI::App& app) {
        judge_command = app.add_subcommand("judge", help::judge);
        judge_command->add_option("CASE", judge.name, "Problem that was solved: see --describe")
            ->required();
        judge_command->add_option(
            "GRID=FILE", judge.files,
            "Cells along the refined side, and the results on them (CSV, VTU, VTKHDF)");
        judge_command->add_flag("--describe", judge.describe,
                                "Say what there is to solve; with --json for programs");
        judge_command
            ->add_option("--field", judge.fields,
                         "Where a field stands, e.g. T=temp:degC; may be repeated")
            ->type_name("NAME=COLUMN:UNIT")
            ->allow_extra_args(false);
        judge_command->add_option("--set", judge.set, "Set a parameter, e.g. depth=\"300 um\"")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        judge_command->add_option("--time", judge.time, "Time of the results, else 0 s")
            ->type_name("T");
        judge_command->add_flag("--from-surface", judge.from_surface,
                                "Count y from the highest point: a level surface that has moved");
        auto* const expect =
            judge_command
                ->add_option("--expect", judge.expect, "Order of all fields, for the case's gates")
                ->type_name("P");
        judge_command->add_option("--within", judge.within, "How far the fit may miss it, else 0.1")
            ->type_name("D")
            ->needs(expect);
        judge_command->add_option("--json", judge.json, "Write JSON; - prints it, and nothing else")
            ->type_name("FILE")
            ->expected(0, 1);
        refuse_empty(
            judge_command->add_option("--junit", judge.junit, "Write JUnit XML, a test a gate"))
            ->type_name("FILE");
        refuse_empty(judge_command->add_option("--out", judge.out,
                                               "Write DIR/verify.json and DIR/report.html"))
            ->type_name("DIR");
        add_footer(judge_command, help::judge_examples);
    }

    void add_points(CLI::App& app) {
        points_command = app.add_subcommand("points", help::points);
        points_command->add_option("FILE", points.file, "VTU or VTKHDF file")->required();
        points_command->add_option("--at", points.at, "Of the fields that are wanted")
            ->check(CLI::IsMember({"points", "cells"}))
            ->capture_default_str();
        refuse_empty(points_command->add_option("--out", points.out, "Write the table there"))
            ->type_name("FILE.csv");
        add_footer(points_command, help::points_examples);
    }

    int run_truth() {
        if (!truth.help) return crawford::truth(truth);
        if (truth.name.empty()) {
            std::cout << truth_command->get_parent()->help();
            return 0;
        }
        TruthOptions description = truth;
        description.list = false;
        description.describe = true;
        return crawford::truth(description);
    }
};

OutsideCommands::OutsideCommands(CLI::App& app) : commands_(std::make_unique<Commands>(app)) {}
OutsideCommands::~OutsideCommands() = default;

std::function<int()> OutsideCommands::action(const std::vector<std::string>& command) const {
    auto* const commands = commands_.get();
    if (commands->order_command->parsed()) return [commands] { return order(commands->order); };
    if (commands->truth_command->parsed()) return [commands] { return commands->run_truth(); };
    if (commands->judge_command->parsed())
        return [commands, command] { return judge(commands->judge, command); };
    if (commands->points_command->parsed())
        return [commands] { return crawford::points(commands->points); };
    return {};
}

}  // namespace crawford
