#include "reports/draw_figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <system_error>

#include "base/atomic_file.hpp"
#include "base/process.hpp"
#include "base/source_tree.hpp"

namespace crawford::reports {
namespace fs = std::filesystem;
namespace {

constexpr double png_pixels_per_point = 2.0;

/// gnuplot's name of what draws it; a movie has ten frames a second.
std::string terminal(Format format) {
    switch (format) {
        case Format::svg:
            return "svg enhanced background 'white'";
        case Format::png:
            return fmt::format("pngcairo enhanced fontscale {}", png_pixels_per_point);
        default:
            return "gif enhanced animate delay 10 loop 0 optimize";
    }
}

/// gnuplot commands that open a panel whose file stands in the variable `output`.
std::string opening(Format format, PanelSize size, const std::string& output) {
    const double scale = format == Format::png ? png_pixels_per_point : 1.0;
    return fmt::format(
        "set terminal {} size {},{} font 'DejaVu Sans,11' linewidth {}; set output {}",
        terminal(format), static_cast<int>(scale * size.width),
        static_cast<int>(scale * size.height), scale, output);
}

std::string literal(const std::variant<double, std::string>& value) {
    if (const auto* const text = std::get_if<std::string>(&value)) return quoted(*text);
    const double number = std::get<double>(value);
    return std::isfinite(number) ? fmt::format("{:.17e}", number) : "NaN";
}

/// What the script knows: everything is set before it is loaded.
std::string prelude(const FigureContents& contents, const fs::path& directory,
                    const std::vector<fs::path>& outputs) {
    std::string text;
    const auto set = [&](const std::string& name, const std::string& expression) {
        text += fmt::format("{} = {}\n", checked_name(name), expression);
    };
    set("caption", quoted(contents.caption));
    for (const Table& table : contents.tables) {
        if (table.kind == Table::Kind::other) continue;
        set("data_" + table.name, quoted((directory / table.file).string()));
        if (table.kind != Table::Kind::columns)
            set("colours_" + table.name,
                quoted(table.kind == Table::Kind::cell_map ? "set pm3d map corners2color c1"
                                                           : "set pm3d map corners2color mean"));
    }
    for (const auto& [name, value] : contents.variables) set(name, literal(value));
    const auto panels = contents.all_panels();
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const auto suffix = panels[i].name.empty() ? "" : "_" + panels[i].name;
        set("output" + suffix, quoted(outputs[i].string()));
        set("panel" + suffix, quoted(opening(panels[i].format, panels[i].size, "output" + suffix)));
    }
    return text + fmt::format("load {}\nload {}\n",
                              quoted(source_path("reports/style.gp").string()),
                              quoted(source_path(contents.script).string()));
}

/// gnuplot goes on after these, but a curve that is not there must not pass for a figure.
bool lacks_data(const std::string& output) {
    return output.find("no valid points") != std::string::npos ||
           output.find("Cannot find or open") != std::string::npos;
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \n"), last = text.find_last_not_of(" \n");
    return first == std::string::npos ? "no message" : text.substr(first, last - first + 1);
}

[[noreturn]] void fail(const FigureContents& contents, const std::string& why) {
    throw FigureFailed(
        fmt::format("{}: {}: {}", contents.name, source_path(contents.script).string(), why));
}

void run_gnuplot(const FigureContents& contents, const fs::path& commands) {
    try {
        const auto gnuplot = run_program({"gnuplot", "-d", commands.string()});
        if (gnuplot.status != 0 || lacks_data(gnuplot.output))
            fail(contents, "gnuplot: " + trimmed(gnuplot.output));
    } catch (const std::system_error& problem) {
        fail(contents, fmt::format("{} (is gnuplot-nox installed?)", problem.what()));
    }
}

}  // namespace

std::string quoted(const std::string& text) {
    std::string literal = "'";
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20)
            throw std::invalid_argument("figure: control character in text");
        literal += c;
        if (c == '\'') literal += c;
    }
    return literal + "'";
}

std::vector<fs::path> draw(const FigureContents& contents, const fs::path& directory) {
    std::vector<AtomicFile> pictures;
    std::vector<fs::path> outputs;
    for (const auto& file : contents.pictures()) {
        pictures.emplace_back(directory / file);
        outputs.push_back(pictures.back().temporary());
    }
    // Never committed: gone when gnuplot is done.
    const AtomicFile commands(directory / (checked_name(contents.name) + ".gp"));
    write_file(commands.temporary(), prelude(contents, directory, outputs));
    run_gnuplot(contents, commands.temporary());
    for (const auto& picture : pictures)
        if (!fs::exists(picture.temporary()) || fs::file_size(picture.temporary()) == 0)
            fail(contents, "no picture " + picture.target().filename().string());

    std::vector<fs::path> drawn;
    for (auto& picture : pictures) {
        picture.commit();
        drawn.push_back(picture.target());
    }
    return drawn;
}

}  // namespace crawford::reports
