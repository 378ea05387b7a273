#include "program/vtk/vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <pugixml.hpp>

#include "base/errors.hpp"
#include "program/vtk/vtu_data.hpp"

namespace crawford::vtk {

namespace {

/// The file taken apart: appended data may be raw bytes, which are no XML.
struct Parts {
    std::string xml;
    std::string_view appended;  ///< after the underscore that it begins with
    bool is_base64 = false;
};

Parts parts(const std::string& text) {
    const auto start = text.find("<AppendedData");
    if (start == std::string::npos) return {text, {}};
    const auto end_of_tag = text.find('>', start);
    const auto data = text.find('_', end_of_tag);
    if (end_of_tag == std::string::npos || data == std::string::npos)
        throw InputError("the appended data do not begin");
    const std::string tag = text.substr(start, end_of_tag - start);
    const auto end = text.rfind("</AppendedData");
    const std::size_t last = end == std::string::npos || end < data ? text.size() : end;
    return {text.substr(0, start) + "</VTKFile>",
            std::string_view(text).substr(data + 1, last - data - 1),
            tag.find("raw") == std::string::npos};
}

Encoding encoding_of(const pugi::xml_node& file) {
    const std::string packed = file.attribute("compressor").as_string();
    if (!packed.empty() && packed != "vtkZLibDataCompressor")
        throw InputError(fmt::format(
            "compressor = \"{}\" is not read; write it with zlib or without compression", packed));
    const std::string header = file.attribute("header_type").as_string("UInt32");
    if (header != "UInt32" && header != "UInt64")
        throw InputError(fmt::format("header_type = \"{}\"; UInt32 or UInt64", header));
    return {.is_big_endian = std::string(file.attribute("byte_order").as_string()) == "BigEndian",
            .header_bytes = std::size_t(header == "UInt64" ? 8 : 4),
            .is_compressed = !packed.empty()};
}

/// A number of a node or of a type.
std::int64_t whole(double number) {
    constexpr double most = 1e9;
    if (!(number >= 0.0 && number < most))
        throw InputError(fmt::format("{} is no number of a node or cell type", number));
    return std::int64_t(number);
}

class Reader {
public:
    explicit Reader(const std::string& text) : parts_(parts(text)) {
        const auto parsed = document_.load_string(parts_.xml.c_str());
        if (!parsed) throw InputError(fmt::format("it is no XML: {}", parsed.description()));
        file_ = document_.child("VTKFile");
        const std::string type = file_.attribute("type").as_string();
        if (type != "UnstructuredGrid")
            throw InputError(fmt::format(
                "VTKFile type = \"{}\"; UnstructuredGrid is read (write a .vtu file)", type));
        encoding_ = encoding_of(file_);
    }

    Mesh mesh() const {
        Mesh mesh;
        bool is_first = true;
        for (const auto& piece : file_.child("UnstructuredGrid").children("Piece")) {
            add(mesh, piece, is_first);
            is_first = false;
        }
        if (is_first) throw InputError("it has no Piece");
        return mesh;
    }

private:
    std::vector<double> numbers(const pugi::xml_node& array) const {
        const std::string format = array.attribute("format").as_string("ascii");
        const std::string_view text = array.text().get();
        if (format == "ascii") return numbers_in_text(text);
        const auto unpack = [&](std::string_view encoded, bool is_base64) {
            return numbers_of(unpacked(encoded, encoding_, is_base64),
                              array.attribute("type").as_string(), encoding_.is_big_endian);
        };
        if (format == "binary") return unpack(text, true);
        const auto offset = array.attribute("offset").as_ullong();
        if (format != "appended" || offset >= parts_.appended.size())
            throw InputError(fmt::format("{}: format = \"{}\" with offset {} of {}",
                                         array.attribute("Name").as_string(), format, offset,
                                         parts_.appended.size()));
        return unpack(parts_.appended.substr(offset), parts_.is_base64);
    }

    std::vector<double> named(const pugi::xml_node& parent, const char* name) const {
        const auto array = parent.find_child_by_attribute("DataArray", "Name", name);
        if (!array) throw InputError(fmt::format("it has no {}", name));
        return numbers(array);
    }

    void add_fields(std::vector<Field>& fields, const pugi::xml_node& data, bool is_first) const {
        std::size_t k = 0;
        for (const auto& array : data.children("DataArray")) {
            const std::string name = array.attribute("Name").as_string();
            if (is_first) {
                const auto components = array.attribute("NumberOfComponents").as_uint(1);
                fields.push_back({.name = name,
                                  .unit = "",
                                  .components = std::max(1U, components),
                                  .values = {}});
            }
            if (k >= fields.size() || fields[k].name != name)
                throw InputError("its pieces do not have the same arrays");
            const auto values = numbers(array);
            fields[k].values.insert(fields[k].values.end(), values.begin(), values.end());
            ++k;
        }
        if (k != fields.size()) throw InputError("its pieces do not have the same arrays");
    }

    void add(Mesh& mesh, const pugi::xml_node& piece, bool is_first) const {
        const auto before = std::int64_t(mesh.points.size());
        add_points(mesh, numbers(piece.child("Points").child("DataArray")));
        add_cells(mesh, piece.child("Cells"), before);
        add_fields(mesh.at_points, piece.child("PointData"), is_first);
        add_fields(mesh.at_cells, piece.child("CellData"), is_first);
    }

    static void add_points(Mesh& mesh, const std::vector<double>& x) {
        if (x.size() % 3 != 0) throw InputError("its points do not have three coordinates each");
        for (std::size_t k = 0; k < x.size(); k += 3)
            mesh.points.emplace_back(x[k], x[k + 1], x[k + 2]);
    }

    void add_cells(Mesh& mesh, const pugi::xml_node& cells, std::int64_t before) const {
        const auto nodes = named(cells, "connectivity"), ends = named(cells, "offsets"),
                   types = named(cells, "types");
        if (ends.size() != types.size()) throw InputError("it has more offsets or types of cells");
        std::size_t from = 0;
        for (std::size_t k = 0; k < ends.size(); ++k) {
            const double end = ends[k];
            if (!(end >= double(from)) || end > double(nodes.size()))
                throw InputError("the offsets of its cells do not rise within their nodes");
            Cell cell{.type = int(whole(types[k])), .nodes = {}};
            for (; from < std::size_t(end); ++from)
                cell.nodes.push_back(before + whole(nodes[from]));
            mesh.cells.push_back(std::move(cell));
        }
    }

    Parts parts_;
    pugi::xml_document document_;
    pugi::xml_node file_;
    Encoding encoding_;
};

}  // namespace

Mesh read_vtu(const std::string& text) {
    return Reader(text).mesh();
}

}  // namespace crawford::vtk
