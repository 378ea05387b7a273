#include "program/points.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iostream>
#include <sstream>
#include <system_error>

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

/// How the reader ended, which prints by itself.
int ending(const std::filesystem::path& file, pid_t reader) {
    int status = 0;
    while (waitpid(reader, &status, 0) < 0)
        if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
    if (WIFEXITED(status)) return WEXITSTATUS(status);
    throw InputError(fmt::format("{}: the reader ended by signal {}: the file is broken",
                                 file.string(), WTERMSIG(status)));
}

int print(const PointsOptions& options) {
    const std::string text = table(options);
    if (options.out.empty())
        std::cout << text;
    else
        write_file(options.out, text);
    return exit_code::done;
}

}  // namespace

bool is_mesh_file(const std::filesystem::path& file) {
    const std::string bytes = beginning(file);
    return is_hdf5(bytes) || bytes.starts_with("<?xml") || bytes.starts_with("<VTKFile");
}

int points(const PointsOptions& options) {
    // HDF5 can break on a broken file: whatever becomes of it there, this program ends in order.
    if (!is_mesh_file(options.file)) return print(options);
    const pid_t reader = fork();
    if (reader < 0) throw std::system_error(errno, std::generic_category(), "fork");
    return reader == 0 ? print(options) : ending(options.file, reader);
}

}  // namespace crawford
