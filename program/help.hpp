/// What --help says besides the options.
#pragma once

namespace crawford::help {

inline constexpr auto program =
    "Crawford burns a composite solid propellant and measures how right it is.";

inline constexpr auto program_examples = R"(
Examples:
  crawford list                                what there is to draw and to verify
  crawford run fig03                           one figure of the paper, into out/figures
  crawford verify slab                         the solver against an exact solution
  crawford burn cases/scenes/sandwich.toml     a scene of your own: copy this file and change it
  crawford order table.csv --expect 2          does another code converge as it should?

crawford COMMAND --help says more.)";

inline constexpr auto exit_codes = R"(
Exit codes: 0 done, 1 a gate fell short, 2 the input is wrong, 3 the numbers failed.)";

inline constexpr auto run =
    "Draw cases: figures and their numbers (CSV, manifest) into DIR/figures";

inline constexpr auto run_examples = R"(
draft takes seconds and is to look at, paper has the grid and step of the paper, fine goes beyond.

Examples:
  crawford run fig03 fig04
  crawford run fig07 fig10 fig11 --fidelity draft --out out/draft
  crawford run fig13 --movie                      the pack burns down, as a GIF
  crawford run fig07 --from-records               after a change of fig07.gp: burns nothing)";

inline constexpr auto ledger = "Set the claims of the paper beside what is found here";

inline constexpr auto ledger_examples = R"(
Writes DIR/figures/ledger.json and its page: claim, paper, ours with uncertainty, reading, verdict.
As a rule the ledger is the one that lies in the source tree. --settle finds its numbers anew: the
readings, refinements and packs that it rests on are burnt. What is burnt is kept, and a run that
was cut off goes on.

--settle --figure finds only the claims that one figure shows (again: those of more) and writes them to
DIR/figures/ledger-FIGURE.json. The ledger of all claims stays as it is; settling it then takes up what
has been burnt.

Examples:
  crawford ledger
  crawford ledger --settle --fidelity draft --out out/draft
  crawford ledger --settle --figure fig10 --figure fig11 --fidelity draft --out out/draft)";

inline constexpr auto verify = "Hold the solver against its truths; exit 1 if a gate falls short";

inline constexpr auto verify_examples = R"(
Prints a line a study, and every gate that fell short (--verbose: every gate) with its errors,
orders and reason. DIR/report.html shows them with their plots and what the studies cover,
DIR/verify.json holds them for programs. Records of the runs are kept in DIR/records: what this very
program has run there is not run again, and --judge-only judges them without running anything.

--grids runs, of each study's own grids, only those listed. Gates that need others are then not
gated: neither pass nor fail, and no verification. A study that is named may also be run on grids
that it does not have.

--against lists the gates that are gone, new or lost, and those whose finest error has changed by
more than the factor of --grown: exit 1 if one has grown. With --exact any number that is not the
same is listed, and anything listed is exit 1.

Examples:
  crawford verify
  crawford verify --grids 32,64                   a quick look
  crawford verify heat 'slab, AP, beta = alpha K' entries of the catalogue, single studies
  crawford verify slab --grids 32,64,128,256,512
  crawford verify --against before/verify.json    what has this change done?
  crawford verify --judge-only --against before/verify.json --exact)";

inline constexpr auto report = "Write the pages anew: figures, ledger, verification";

inline constexpr auto report_examples = R"(
Computes nothing: makes of what lies in DIR what is there to make of it.

  DIR/records/CASE.jsonl        a page for each case that has been drawn, and figures/index.html
  DIR/figures/ledger.json       figures/ledger.html
  DIR/verify/verify.json        verify/report.html
  DIR/verify.json               report.html

Examples:
  crawford report
  crawford report --out out/verify)";

inline constexpr auto burn = "Burn a scene: snapshots, history, checkpoints and manifest into DIR";

inline constexpr auto burn_examples = R"(
Snapshots are VTKHDF: open DIR/<scene>.hdf.series in ParaView.

Examples:
  crawford burn cases/scenes/sandwich.toml
  crawford burn cases/scenes/sandwich.toml --check       can it be believed? runs nothing
  crawford burn cases/scenes/sandwich.toml --set surface.heat_flux="9 MW/m2"
  crawford burn cases/scenes/sandwich.toml --out out/sandwich --set time.until_steady= \
      --set time.end="0.12 s" --restart out/sandwich/sandwich_checkpoint_004000.h5)";

inline constexpr auto pack = "Write the discs of a scene, as a rule a random pack, as CSV";

inline constexpr auto pack_examples = R"(
The table is what a scene with kind = "discs" reads. docs/packs.md says how packs are made.

Examples:
  crawford pack cases/scenes/random_pack.toml --set morphology.seed=7 --out pack7.csv
  crawford pack cases/scenes/random_pack.toml --set morphology.area_fraction=0.6)";

}  // namespace crawford::help
