/// VTKHDF files that HDF5 can read and that hold any numbers in arrays of any size: what Crawford makes of them. What
/// HDF5 makes of a broken file is looked at through the program (program_fuzz.cpp).
#include <fuzzer/FuzzedDataProvider.h>

#include "program/vtk/mesh_table.hpp"
#include "program/vtk/vtkhdf.hpp"
#include "solver/files/hdf5_file.hpp"
#include "tests/fuzz/contract.hpp"

namespace {

using crawford::Hdf5File;

constexpr std::size_t most = 12;  // numbers of an array: enough for two cells

/// A whole number as files hold them: small, or any.
std::int64_t whole(FuzzedDataProvider& data) {
    return data.ConsumeBool() ? data.ConsumeIntegralInRange<std::int64_t>(-1, most)
                              : data.ConsumeIntegral<std::int64_t>();
}

void write_whole(Hdf5File& file, const std::string& path, FuzzedDataProvider& data) {
    std::vector<std::int64_t> numbers(data.ConsumeIntegralInRange<std::size_t>(0, most));
    for (auto& number : numbers) number = whole(data);
    file.write(path, std::span<const std::int64_t>(numbers), {numbers.size()}, "1");
}

void write_numbers(Hdf5File& file, const std::string& path, FuzzedDataProvider& data) {
    const auto rows = data.ConsumeIntegralInRange<hsize_t>(0, most);
    const auto columns = data.ConsumeIntegralInRange<hsize_t>(0, 4);
    std::vector<double> numbers(rows * columns);
    for (auto& number : numbers)
        number = data.ConsumeBool() ? double(whole(data)) : data.ConsumeFloatingPoint<double>();
    if (data.ConsumeBool())
        file.write(path, std::span<const double>(numbers), {rows, columns}, "K");
    else
        file.write(path, std::span<const double>(numbers), {rows * columns}, "K");
}

void write(const std::filesystem::path& path, FuzzedDataProvider& data) {
    Hdf5File file = Hdf5File::create(path);
    file.create_group("/VTKHDF");
    write_numbers(file, "/VTKHDF/Points", data);
    for (const char* name : {"Connectivity", "Offsets", "Types", "NumberOfPoints", "NumberOfCells",
                             "NumberOfConnectivityIds"})
        write_whole(file, std::string("/VTKHDF/") + name, data);
    for (const char* group : {"/VTKHDF/PointData", "/VTKHDF/CellData"})
        if (data.ConsumeBool()) {
            file.create_group(group);
            write_numbers(file, std::string(group) + "/field", data);
        }
    file.publish();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace crawford::vtk;
    const auto path = crawford::fuzz::file_of(nullptr, 0, "mesh.hdf");
    FuzzedDataProvider data(bytes, size);
    write(path, data);
    crawford::fuzz::must_answer([&] {
        const Mesh mesh = read_vtkhdf(path);
        crawford::fuzz::must_answer([&] { table_of_points(mesh); });
        table_of_cells(mesh);
    });
    return 0;
}
