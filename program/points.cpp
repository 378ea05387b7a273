#include "program/points.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <sstream>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "program/commands.hpp"
#include "program/vtk/mesh_table.hpp"
#include "program/vtk/vtkhdf.hpp"
#include "program/vtk/vtu.hpp"

namespace crawford {

namespace {

std::ifstream opened(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file))
        throw InputError(fmt::format("cannot read {}", file.string()));
    return stream;
}

std::string beginning(const std::filesystem::path& file) {
    std::string bytes(8, '\0');
    auto stream = opened(file);
    stream.read(bytes.data(), std::streamsize(bytes.size()));
    bytes.resize(std::size_t(stream.gcount()));
    return bytes;
}

bool is_hdf5(const std::string& beginning) {
    return beginning.starts_with("\x89HDF\r\n\x1a\n");
}

vtk::Mesh read_mesh(const std::filesystem::path& file) {
    if (is_hdf5(beginning(file))) return vtk::read_vtkhdf(file);
    std::ostringstream text;
    text << opened(file).rdbuf();
    return vtk::read_vtu(text.str());
}

std::string table(const PointsOptions& options) {
    try {
        const vtk::Mesh mesh = read_mesh(options.file);
        return options.at == "cells" ? table_of_cells(mesh) : table_of_points(mesh);
    } catch (const InputError& error) {
        const std::string name = options.file.string(), text = error.what();
        throw InputError(text.find(name) == std::string::npos ? name + ": " + text : text);
    }
}

}  // namespace

bool is_mesh_file(const std::filesystem::path& file) {
    const std::string bytes = beginning(file);
    return is_hdf5(bytes) || bytes.starts_with("<?xml") || bytes.starts_with("<VTKFile");
}

int points(const PointsOptions& options) {
    const std::string text = table(options);
    if (options.out.empty())
        std::cout << text;
    else
        write_file(options.out, text);
    return exit_code::done;
}

}  // namespace crawford
