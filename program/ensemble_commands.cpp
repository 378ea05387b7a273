#include "program/ensemble_commands.hpp"

#include <CLI/CLI.hpp>

#include "program/command_options.hpp"
#include "program/ensemble_options.hpp"

namespace crawford {

namespace {

constexpr auto runs_help = "What burns lie in a folder, or the key that a scene is known by";

constexpr auto runs_examples = R"(
A key is a digest of physics, numerics and end of a scene, in full: what it writes and its title are
no part of it. States: done, running, cut off, failed, unreadable. docs/ensembles.md is a tour.

Examples:
  crawford runs --list
  crawford runs --list --out out/ensemble --json
  crawford runs --key cases/scenes/random_pack.toml --set morphology.seed=7)";

constexpr auto gather_help = "Make a table and a page of burns that differ in their packs";

constexpr auto gather_examples = R"(
Burns that differ in nothing but where their discs lie are one point: mean, standard deviation,
Student's confidence interval, and how many packs a wanted interval takes. Burns that failed are
listed with their reason. Writes points.csv, burns.csv, ensemble.json, ensemble.html, figures/.

Examples:
  crawford gather out/ensemble/burns --out out/ensemble
  crawford gather --from out/ensemble/folders.txt --out out/ensemble
  crawford gather out/ensemble/burns --out out/half --interval "0.5 %" --after "10 ms")";

}  // namespace

struct EnsembleCommands::Commands {
    RunsOptions runs;
    GatherOptions gather;
    CLI::App* runs_command = nullptr;
    CLI::App* gather_command = nullptr;

    explicit Commands(CLI::App& app) {
        add_runs(app);
        add_gather(app);
    }

    void add_runs(CLI::App& app) {
        runs_command = app.add_subcommand("runs", runs_help);
        auto* const list = runs_command->add_flag("--list", runs.list, "A line for each burn");
        auto* const key =
            refuse_empty(runs_command->add_option("--key", runs.key, "Print the key of this scene"))
                ->type_name("SCENE")
                ->excludes(list);
        runs_command
            ->add_option("--set", runs.set, "Set a key of the scene, e.g. morphology.seed=2")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false)
            ->needs(key);
        refuse_empty(runs_command->add_option("--out", runs.out, "Folder to look through"))
            ->type_name("DIR")
            ->capture_default_str();
        runs_command->add_flag("--json", runs.json, "Print JSON, and nothing else");
        add_footer(runs_command, runs_examples);
    }

    void add_gather(CLI::App& app) {
        gather_command = app.add_subcommand("gather", gather_help);
        gather_command->add_option("DIR", gather.folders, "Folders with burns, at any depth");
        refuse_empty(gather_command->add_option("--from", gather.from,
                                                "A file that names more folders, one a line"))
            ->type_name("FILE");
        refuse_empty(gather_command->add_option("--out", gather.out, "Where the tables go"))
            ->type_name("DIR")
            ->required();
        gather_command
            ->add_option("--after", gather.after,
                         "Time from which on a burn counts, e.g. \"10 ms\"; else half of time.end")
            ->type_name("T");
        gather_command
            ->add_option("--interval", gather.interval,
                         "Half-width that is wanted, of the mean: how many packs does it take?")
            ->type_name("PART")
            ->capture_default_str();
        gather_command->add_option("--confidence", gather.confidence, "Of the intervals")
            ->type_name("PART")
            ->capture_default_str();
        gather_command->add_option("--title", gather.title, "Of the page")
            ->type_name("TEXT")
            ->capture_default_str();
        add_footer(gather_command, gather_examples);
    }
};

EnsembleCommands::EnsembleCommands(CLI::App& app) : commands_(std::make_unique<Commands>(app)) {}
EnsembleCommands::~EnsembleCommands() = default;

std::function<int()> EnsembleCommands::action(const std::vector<std::string>& command) const {
    auto* const commands = commands_.get();
    if (commands->runs_command->parsed()) return [commands] { return runs(commands->runs); };
    if (commands->gather_command->parsed())
        return [commands, command] { return gather(commands->gather, command); };
    return {};
}

}  // namespace crawford
