/// VTU files as tables of points and of cells.
#include "program/vtk/mesh_table.hpp"
#include "program/vtk/vtu.hpp"
#include "tests/fuzz/contract.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace crawford::vtk;
    crawford::fuzz::must_answer([&] {
        const Mesh mesh = read_vtu(std::string(crawford::fuzz::text_of(bytes, size)));
        crawford::fuzz::must_answer([&] { table_of_points(mesh); });
        table_of_cells(mesh);
    });
    return 0;
}
