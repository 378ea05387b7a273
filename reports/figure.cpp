#include "reports/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "base/atomic_file.hpp"
#include "base/process.hpp"
#include "base/scratch.hpp"
#include "base/source_tree.hpp"

namespace crawford::reports {
namespace fs = std::filesystem;
namespace {

constexpr double png_pixels_per_point = 2.0;

std::string checked(const std::string& name) {
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_';
    };
    if (name.empty() || !std::ranges::all_of(name, fits))
        throw std::invalid_argument(
            fmt::format("figure: '{}' must be letters, digits and '_' only", name));
    return name;
}

/// A gnuplot string literal in which nothing is special: single-quoted, the quote itself doubled.
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

std::string extension(Format format) {
    return format == Format::svg ? ".svg" : format == Format::png ? ".png" : ".gif";
}

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

/// gnuplot goes on after these, but a curve that is not there must not pass for a figure.
bool lacks_data(const std::string& output) {
    return output.find("no valid points") != std::string::npos ||
           output.find("Cannot find or open") != std::string::npos;
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \n"), last = text.find_last_not_of(" \n");
    return first == std::string::npos ? "no message" : text.substr(first, last - first + 1);
}

}  // namespace

Figure::Figure(const std::string& name, const fs::path& out, const fs::path& script)
    : name_(checked(name)),
      directory_(fs::absolute(out / "figures")),
      script_(source_path(script)) {}

fs::path Figure::file(const std::string& suffix) const {
    return directory_ / (name_ + suffix);
}

fs::path Figure::numbers(const std::string& table) const {
    const auto name = name_ + "_" + checked(table) + ".csv";
    return (scratch_ ? scratch_->path() : directory_) / name;
}

Figure& Figure::forget_numbers() {
    scratch_ = std::make_shared<const Scratch>();
    return *this;
}

Figure& Figure::table(const std::string& name, const std::vector<Column>& columns) {
    const auto path = numbers(name);
    write_file(path, csv(columns));
    variables_["data_" + name] = quoted(path.string());
    if (!scratch_) data_.push_back(path);
    return *this;
}

Figure& Figure::map(const std::string& name, const QuadMap& quads) {
    const auto path = numbers(name);
    write_file(path, csv(quads));
    variables_["data_" + name] = quoted(path.string());
    if (!scratch_) data_.push_back(path);
    variables_["colours_" + name] = quoted(quads.at_cells() ? "set pm3d map corners2color c1"
                                                            : "set pm3d map corners2color mean");
    return *this;
}

Figure& Figure::set(const std::string& name, double value) {
    variables_[checked(name)] = std::isfinite(value) ? fmt::format("{:.17e}", value) : "NaN";
    return *this;
}

Figure& Figure::set(const std::string& name, const std::string& text) {
    variables_[checked(name)] = quoted(text);
    return *this;
}

Figure& Figure::caption(const Caption& caption) {
    std::string text;
    const auto add = [&](const std::string& label, const std::string& value) {
        if (!value.empty()) text += (text.empty() ? "" : "  |  ") + label + value;
    };
    add("grid ", caption.grid);
    add("step ", caption.step);
    add("", caption.note);
    add("revision ", caption.revision);
    return set("caption", text);
}

Figure& Figure::panel(const std::string& name, Format format, PanelSize size) {
    return add({checked(name), format, size});
}

Figure& Figure::panel(Format format, PanelSize size) {
    return add({"", format, size});
}

Figure& Figure::add(const Panel& panel) {
    for (const Panel& other : panels_)
        if (other.name == panel.name || other.name.empty() || panel.name.empty())
            throw std::invalid_argument(
                fmt::format("figure: {} has panel '{}' and cannot have '{}' too", name_, other.name,
                            panel.name));
    panels_.push_back(panel);
    return *this;
}

std::string Figure::prelude(const std::vector<Panel>& panels,
                            const std::vector<fs::path>& outputs) const {
    std::string text = "caption = ''\n";
    for (const auto& [name, expression] : variables_)
        text += fmt::format("{} = {}\n", name, expression);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const auto suffix = panels[i].name.empty() ? "" : "_" + panels[i].name;
        text += fmt::format("output{} = {}\n", suffix, quoted(outputs[i].string()));
        text += fmt::format("panel{} = {}\n", suffix,
                            quoted(opening(panels[i].format, panels[i].size, "output" + suffix)));
    }
    text += fmt::format("load {}\nload {}\n", quoted(source_path("reports/style.gp").string()),
                        quoted(script_.string()));
    return text;
}

std::vector<fs::path> Figure::draw() const {
    const auto panels = panels_.empty() ? std::vector<Panel>{{"", Format::svg, {}}} : panels_;
    std::vector<AtomicFile> pictures;
    std::vector<fs::path> outputs;
    for (const auto& panel : panels) {
        pictures.emplace_back(file(panel.name + extension(panel.format)));
        outputs.push_back(pictures.back().temporary());
    }
    const AtomicFile commands(file(".gp"));  // never committed: gone when gnuplot is done
    write_file(commands.temporary(), prelude(panels, outputs));

    const auto fail = [&](const std::string& why) {
        throw FigureFailed(fmt::format("{}: {}: {}", name_, script_.string(), why));
    };
    try {
        const auto gnuplot = run_program({"gnuplot", "-d", commands.temporary().string()});
        if (gnuplot.status != 0 || lacks_data(gnuplot.output))
            fail("gnuplot: " + trimmed(gnuplot.output));
    } catch (const std::system_error& problem) {
        fail(fmt::format("{} (is gnuplot-nox installed?)", problem.what()));
    }
    for (const auto& picture : pictures)
        if (!fs::exists(picture.temporary()) || fs::file_size(picture.temporary()) == 0)
            fail("no picture " + picture.target().filename().string());

    std::vector<fs::path> drawn;
    for (auto& picture : pictures) {
        picture.commit();
        drawn.push_back(picture.target());
    }
    return drawn;
}

}  // namespace crawford::reports
