#include "reports/figure.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/atomic_file.hpp"
#include "base/scratch.hpp"
#include "base/source_tree.hpp"

namespace crawford::reports {
namespace fs = std::filesystem;
namespace {

std::string small_print(const Caption& caption) {
    std::string text;
    const auto add = [&](const std::string& label, const std::string& value) {
        if (!value.empty()) text += (text.empty() ? "" : "  |  ") + label + value;
    };
    add("grid ", caption.grid);
    add("step ", caption.step);
    add("", caption.note);
    add("revision ", caption.revision);
    return text;
}

}  // namespace

fs::path script_of(const fs::path& source) {
    return place_in_source_tree(source).replace_extension(".gp");
}

Figure::Figure(const std::string& name, const fs::path& out, const fs::path& script)
    : contents_{.name = checked_name(name), .script = script},
      directory_(fs::absolute(out / "figures")) {}

Figure& Figure::forget_numbers() {
    scratch_ = std::make_shared<const Scratch>();
    contents_.keeps_numbers = false;
    return *this;
}

Figure& Figure::table(const std::string& name, const std::vector<Column>& columns) {
    return add(name, Table::Kind::columns, csv(columns));
}

Figure& Figure::map(const std::string& name, const QuadMap& quads) {
    return add(name, quads.at_cells() ? Table::Kind::cell_map : Table::Kind::corner_map,
               csv(quads));
}

Figure& Figure::other(const std::string& name, const fs::path& file, const std::string& text) {
    write_file(directory_ / file, text);
    contents_.tables.push_back({checked_name(name), Table::Kind::other, file});
    return *this;
}

Figure& Figure::add(const std::string& table, Table::Kind kind, const std::string& numbers) {
    const fs::path file = contents_.name + "_" + checked_name(table) + ".csv";
    write_file((scratch_ ? scratch_->path() : directory_) / file, numbers);
    contents_.tables.push_back({table, kind, scratch_ ? scratch_->path() / file : file});
    return *this;
}

Figure& Figure::set(const std::string& name, double value) {
    contents_.variables[checked_name(name)] = value;
    return *this;
}

Figure& Figure::set(const std::string& name, const std::string& text) {
    quoted(text);  // refuses at once what no script can hold
    contents_.variables[checked_name(name)] = text;
    return *this;
}

Figure& Figure::caption(const Caption& caption) {
    contents_.caption = small_print(caption);
    return *this;
}

Figure& Figure::panel(const std::string& name, Format format, PanelSize size) {
    return add({checked_name(name), format, size});
}

Figure& Figure::panel(Format format, PanelSize size) {
    return add({"", format, size});
}

Figure& Figure::add(const Panel& panel) {
    for (const Panel& other : contents_.panels)
        if (other.name == panel.name || other.name.empty() || panel.name.empty())
            throw std::invalid_argument(
                fmt::format("figure: {} has panel '{}' and cannot have '{}' too", contents_.name,
                            other.name, panel.name));
    contents_.panels.push_back(panel);
    return *this;
}

std::vector<fs::path> Figure::draw() const {
    return reports::draw(contents_, directory_);
}

}  // namespace crawford::reports
