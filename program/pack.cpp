#include "solver/packing/pack.hpp"

#include <fmt/format.h>

#include <iostream>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "program/commands.hpp"
#include "program/typed_scene.hpp"
#include "solver/scene/write_discs.hpp"

namespace crawford {

int pack(const PackOptions& options) {
    constexpr double micrometre = 1e-6;  // [m]
    const Scene scene = typed_scene(options.scene, options.set);
    const auto* discs = std::get_if<Discs>(&scene.morphology.shape);
    if (discs == nullptr)
        throw InputError(
            fmt::format("{} has no discs to write; give it a [morphology] of kind = "
                        "\"pack\", see cases/scenes/random_pack.toml",
                        options.scene.string()));
    const std::filesystem::path file =
        options.out.empty() ? std::filesystem::path("out") / (name_of_scene(options.scene) + ".csv")
                            : options.out;
    if (file.has_parent_path()) prepare_directory(file.parent_path());
    write_file(file, discs_csv(*discs));
    std::cout << fmt::format(
        "{} discs, area fraction {:.6g}, smallest gap {:.4g} um, in {}\n"
        "To burn them, with domain.width = {:.6g} um:\n\n"
        "[morphology]\nkind = \"discs\"\nfile = \"{}\"\nperiod = \"{} m\"\n",
        discs->discs.size(), area_fraction(*discs, scene.domain.width),
        smallest_gap(*discs, scene.domain.width) / micrometre, file.string(),
        scene.domain.width / micrometre, file.filename().string(), discs->period);
    return exit_code::done;
}

}  // namespace crawford
