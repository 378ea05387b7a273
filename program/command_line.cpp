#include "program/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include "base/build_info.hpp"
#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "program/accuracy.hpp"
#include "program/chosen_grids.hpp"
#include "program/command_options.hpp"
#include "program/ensemble_commands.hpp"
#include "program/help.hpp"
#include "program/outside_commands.hpp"

namespace crawford {

namespace {

/// The CLI11 parser and what it fills.
struct Parser {
    CLI::App app{help::program, "crawford"};
    ListOptions list;
    RunOptions run;
    LedgerOptions ledger;
    VerifyOptions verify;
    ReportOptions report;
    BurnSceneOptions burn;
    PackOptions pack;
    bool quiet = false;  ///< said before the command
    CLI::App* list_command = nullptr;
    CLI::App* run_command = nullptr;
    CLI::App* ledger_command = nullptr;
    CLI::App* verify_command = nullptr;
    CLI::App* report_command = nullptr;
    CLI::App* burn_command = nullptr;
    CLI::App* pack_command = nullptr;
    std::optional<OutsideCommands> outside;
    std::optional<EnsembleCommands> ensemble;

    Parser() {
        app.set_version_flag("--version",
                             fmt::format("crawford {} ({}, {})", version(), revision(), compiler()),
                             "Print version, revision and compiler");
        app.require_subcommand(1);
        add_quiet(&app, quiet);
        app.get_formatter()->column_width(34);
        add_footer(&app, help::program_examples);
        add_list();
        add_run();
        add_ledger();
        add_verify();
        add_report();
        add_burn();
        add_pack();
        outside.emplace(app);
        ensemble.emplace(app);
    }

    void add_list() {
        list_command = app.add_subcommand("list", "Show the catalogue of cases and studies");
        list_command->add_flag("--studies", list.studies,
                               "Only the studies, a name and its cost in seconds on each line");
    }

    void add_run() {
        run_command = app.add_subcommand("run", help::run);
        run_command->add_option("CASE", run.cases, "Cases to draw (crawford list)");
        run_command->add_flag("--all", run.all, "Draw every case: 25 minutes at paper");
        auto* const fidelity =
            run_command->add_option("--fidelity", run.fidelity, "draft, paper or fine")
                ->type_name("WORD")
                ->capture_default_str();
        add_out(run_command, run.out, "out")->capture_default_str();
        run_command->add_flag("--again", run.again,
                              "Draw also what is up to date (burns are kept)");
        run_command->add_flag("--movie", run.movie,
                              "Draw the movie of a case, DIR/figures/CASE.gif (fig13 has one)");
        run_command
            ->add_flag("--from-records", run.from_records,
                       "Draw again from DIR/records and the CSV files: burn nothing")
            ->excludes("--again");
        run_command->callback([this, fidelity] {
            if (run.from_records && fidelity->count() == 0) run.fidelity.clear();
        });
        add_threads(run_command, run.threads);
        add_quiet(run_command, run.quiet);
        add_footer(run_command, help::run_examples);
    }

    void add_ledger() {
        ledger_command = app.add_subcommand("ledger", help::ledger);
        ledger_command->add_flag("--settle", ledger.settle,
                                 "Burn all that it rests on: hours at paper, minutes at draft");
        ledger_command
            ->add_option("--figure", ledger.figures, "Settle only the claims that these cases show")
            ->type_name("CASE")
            ->allow_extra_args(false)
            ->needs("--settle");
        ledger_command->add_option("--fidelity", ledger.fidelity, "draft, paper or fine")
            ->type_name("WORD")
            ->capture_default_str();
        add_out(ledger_command, ledger.out, "out")->capture_default_str();
        add_threads(ledger_command, ledger.threads);
        add_quiet(ledger_command, ledger.quiet);
        add_footer(ledger_command, help::ledger_examples);
    }

    void add_verify() {
        verify_command = app.add_subcommand("verify", help::verify);
        verify_command->add_option("STUDY", verify.studies, "Studies to run; all if none is named");
        verify_command
            ->add_option_function<std::vector<std::string>>(
                "--grids",
                [this](const std::vector<std::string>& words) {
                    verify.grids = whole_numbers("--grids", words);
                },
                "Only these grids: a quick look, or a finer one")
            ->type_name("N,N,...")
            ->delimiter(',')
            ->allow_extra_args(false);
        verify_command
            ->add_option("--axis", verify.axis,
                         "Only studies that refine this axis, on these values of it")
            ->type_name("NAME=N,N,...")
            ->excludes("--grids");
        verify_command->add_flag("--judge-only", verify.judge_only,
                                 "Run nothing: judge the records that lie in DIR/records");
        add_against();
        verify_command->add_flag("--verbose", verify.verbose, "Print every gate in full");
        refuse_empty(
            verify_command->add_option("--junit", verify.junit, "Write JUnit XML, a test a gate"))
            ->type_name("FILE");
        add_out(verify_command, verify.out, "out/verify")->capture_default_str();
        add_threads(verify_command, verify.threads);
        add_quiet(verify_command, verify.quiet);
        add_footer(verify_command, help::verify_examples);
    }

    void add_against() {
        CLI::Option* against =
            refuse_empty(verify_command->add_option(
                             "--against", verify.against,
                             "List what is gone, new or other than in this earlier verify.json"))
                ->type_name("FILE");
        verify_command
            ->add_option("--grown", verify.grown,
                         "Factor by which the finest error of a gate may grow, else 1.05")
            ->type_name("FACTOR")
            ->needs(against);
        verify_command
            ->add_flag("--exact", verify.exact,
                       "Against it, every number must be the same, bit by bit")
            ->needs(against);
    }

    void add_report() {
        report_command = app.add_subcommand("report", help::report);
        refuse_empty(report_command->add_option("--out", report.out, "Directory with results"))
            ->type_name("DIR")
            ->capture_default_str();
        add_footer(report_command, help::report_examples);
    }

    void add_burn() {
        burn_command = app.add_subcommand("burn", help::burn);
        burn_command
            ->add_option("SCENE", burn.scene,
                         "Scene file (TOML), see cases/scenes/; - reads standard input")
            ->required();
        add_set(burn_command, burn.set, "surface.heat_flux=\"190 cal/(s cm2)\"");
        add_out(burn_command, burn.out, "out/<name of the scene>");
        auto* const restart =
            refuse_empty(burn_command->add_option("--restart", burn.restart,
                                                  "Go on from a checkpoint of this scene"))
                ->type_name("FILE");
        burn_command
            ->add_flag("--resume", burn.resume,
                       "Go on from what lies in DIR: its last checkpoint, or nothing; if done, end")
            ->excludes(restart);
        auto* const preset =
            burn_command->add_option("--preset", burn.preset, "Choose grid and steps: see below")
                ->type_name("NAME");
        burn_command
            ->add_option("--accuracy", burn.accuracy,
                         "The cheapest preset that promises V so accurately, e.g. \"1 %\"")
            ->type_name("PART")
            ->excludes(preset);
        burn_command->add_flag("--as-written", burn.as_written,
                               "Compute also what a symmetry or one material in x makes known");
        burn_command->add_flag("--timing", burn.timing, "Print where the time went");
        burn_command->add_flag("--check", burn.check,
                               "Run nothing: print the scene's numbers and their limits");
        burn_command->add_flag("--json", burn.json,
                               "Print how it ended as one line of JSON, and words on stderr; with "
                               "--check its numbers");
        add_quiet(burn_command, burn.quiet);
        burn_command->footer("");  // not the program's own besides
        burn_command->footer([] {
            return fmt::format("{}\n\nPresets:\n{}{}", help::burn_examples, presets_in_words(),
                               help::exit_codes);
        });
    }

    void add_pack() {
        pack_command = app.add_subcommand("pack", help::pack);
        pack_command->add_option("SCENE", pack.scene, "Scene file (TOML) with a pack")->required();
        add_set(pack_command, pack.set, "morphology.seed=2");
        refuse_empty(pack_command->add_option("--out", pack.out,
                                              "Table to write, else out/<name of the scene>.csv"))
            ->type_name("FILE");
        add_footer(pack_command, help::pack_examples);
    }

    static void add_set(CLI::App* command, std::vector<std::string>& set, const char* example) {
        command->add_option("--set", set, fmt::format("Set a key of the scene, e.g. {}", example))
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
    }

    static CLI::Option* add_out(CLI::App* command, std::filesystem::path& out, const char* usual) {
        return refuse_empty(
                   command->add_option("--out", out,
                                       fmt::format("Directory for the results, else {}", usual)))
            ->type_name("DIR");
    }

    static void add_threads(CLI::App* command, std::optional<unsigned>& threads) {
        constexpr unsigned most = 1024;  // of one machine; more is a slip
        command->add_option("--threads", threads, "How many run side by side, else one a core")
            ->type_name("N")
            ->check(CLI::Range(1U, most));
    }

    static void add_quiet(CLI::App* command, bool& quiet) {
        command->add_flag("--quiet,-q", quiet, "No progress on stderr");
    }

    /// The command that was named, or the program.
    const CLI::App& named() const {
        const auto commands = app.get_subcommands();
        return commands.empty() ? app : *commands.front();
    }
};

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

[[noreturn]] void refuse_unknown(const Parser& parser, const std::string& word) {
    const CLI::App& command = parser.named();
    const std::string typed = word.substr(0, word.find('='));
    if (typed.starts_with("-"))
        throw InputError(
            fmt::format("unknown option {}{}", typed, suggestion(typed, option_names(command))));
    if (&command == &parser.app)
        throw InputError(fmt::format("unknown command {}{}", typed,
                                     suggestion(typed, command_names(parser.app))));
    throw InputError(
        fmt::format("unexpected argument {}; see crawford {} --help", typed, command.get_name()));
}

[[noreturn]] void refuse(const Parser& parser, const CLI::ParseError& error) {
    const auto unknown = parser.app.remaining(true);
    if (!unknown.empty()) refuse_unknown(parser, unknown.front());
    const CLI::App& command = parser.named();
    if (&command == &parser.app)
        throw InputError(
            "a command is missing: list, run, ledger, verify, report, burn, pack, order, truth, "
            "judge, points, runs or gather; see crawford --help");
    throw InputError(fmt::format("{}; see crawford {} --help", error.what(), command.get_name()));
}

Action action_of(const std::shared_ptr<Parser>& parser, const CommandLine& arguments) {
    // The parser lives as long as what it has read is used: a command may print its help.
    if (const auto action = parser->outside->action(arguments))
        return [parser, action] { return action(); };
    if (const auto action = parser->ensemble->action(arguments))
        return [parser, action] { return action(); };
    if (parser->list_command->parsed()) return [parser] { return list(parser->list); };
    if (parser->report_command->parsed()) return [parser] { return report(parser->report); };
    if (parser->run_command->parsed())
        return [parser, arguments] { return run(parser->run, arguments); };
    if (parser->ledger_command->parsed())
        return [parser, arguments] { return settle_ledger(parser->ledger, arguments); };
    if (parser->verify_command->parsed())
        return [parser, arguments] { return verify(parser->verify, arguments); };
    if (parser->pack_command->parsed()) return [parser] { return pack(parser->pack); };
    return [parser, arguments] { return burn(parser->burn, arguments); };
}

}  // namespace

std::variant<Action, Answer> read_command_line(const CommandLine& arguments) {
    const auto parser = std::make_shared<Parser>();
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend() - 1);
    try {
        parser->app.parse(std::move(reversed));
    } catch (const CLI::CallForHelp&) {
        if (const auto unknown = parser->app.remaining(true); !unknown.empty())
            refuse_unknown(*parser, unknown.front());
        return Answer{parser->app.help()};
    } catch (const CLI::CallForVersion& answer) {
        return Answer{std::string(answer.what()) + '\n'};
    } catch (const CLI::ParseError& error) {
        refuse(*parser, error);
    }
    if (parser->quiet)
        for (bool* quiet : {&parser->run.quiet, &parser->ledger.quiet, &parser->verify.quiet,
                            &parser->burn.quiet})
            *quiet = true;
    return action_of(parser, arguments);
}

}  // namespace crawford
