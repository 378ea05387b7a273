// `crawford points` on files of meshes that say what is not true: refused in one line, whatever HDF5 makes of them.
#include <hdf5.h>

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "base/source_tree.hpp"
#include "solver/files/hdf5_file.hpp"
#include "tests/program/program.hpp"

namespace crawford {
namespace {

namespace fs = std::filesystem;
using Whole = std::vector<std::int64_t>;

/// Two triangles, in VTKHDF's arrays.
struct Arrays {
    std::map<std::string, Whole> whole{
        {"NumberOfPoints", {4}},          {"NumberOfCells", {2}},
        {"NumberOfConnectivityIds", {6}}, {"Connectivity", {0, 1, 2, 1, 3, 2}},
        {"Offsets", {0, 3, 6}},           {"Types", {5, 5}}};
    std::vector<double> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
};

class BrokenMesh : public ProgramTest {
protected:
    static void write(const fs::path& path, const Arrays& arrays) {
        Hdf5File file = Hdf5File::create(path);
        file.create_group("/VTKHDF");
        file.write("/VTKHDF/Points", std::span<const double>(arrays.points),
                   {arrays.points.size() / 3, 3}, "m");
        for (const auto& [name, numbers] : arrays.whole)
            file.write("/VTKHDF/" + name, std::span<const std::int64_t>(numbers), {numbers.size()},
                       "1");
        file.publish();
    }
    /// The file with something of HDF5's own put in.
    void alter(const std::function<void(hid_t file)>& change) const {
        const hid_t file = H5Fopen(path().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
        ASSERT_GE(file, 0);
        change(file);
        H5Fclose(file);
    }
    fs::path path() const { return out_ / "mesh.hdf"; }
    void refused(const std::string& name, Whole numbers, const std::string& message) const {
        Arrays arrays;
        arrays.whole.at(name) = std::move(numbers);
        write(path(), arrays);
        SCOPED_TRACE(name);
        expect_refused({"points", path().string()}, message);
    }
};

TEST_F(BrokenMesh, OfSizesThatAreNotThereIsRefused) {
    fs::create_directories(out_);
    constexpr auto largest = std::numeric_limits<std::int64_t>::max(),
                   least = std::numeric_limits<std::int64_t>::min();
    write(path(), {});
    const Finished sound = crawford({"points", path().string()});
    EXPECT_EQ(sound.status, 0) << sound.output;
    for (const std::int64_t size : {std::int64_t(-1), std::int64_t(7), largest, least})
        for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
            refused(name, {size}, "more than it has in all");
    refused("NumberOfCells", {2, 0}, "not as many in all");
    for (const std::int64_t node : {std::int64_t(-1), std::int64_t(4), largest, least})
        refused("Connectivity", {0, 1, 2, 1, 3, node}, "a node that there is not");
    for (const Whole& offsets :
         {Whole{0, 6, 3}, Whole{-1, 3, 6}, Whole{0, 3, 7}, Whole{0, 3, largest}})
        refused("Offsets", offsets, "do not rise within their nodes");
    refused("Offsets", {0, 3}, "more than it has in all");
    refused("Offsets", {}, "more than it has in all");
    // A large file of nodes that each cell claims anew would fill any memory.
    refused("Offsets", {0, 6, 0}, "do not rise");
}

TEST_F(BrokenMesh, WhoseNumbersTheFileCannotHoldIsRefused) {
    fs::create_directories(out_);
    write(path(), {});
    alter([](hid_t file) {
        H5Ldelete(file, "/VTKHDF/Points", H5P_DEFAULT);
        const hsize_t shape[2] = {hsize_t(1) << 40, 3}, chunk[2] = {1024, 3};
        const hid_t space = H5Screate_simple(2, shape, nullptr),
                    properties = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_chunk(properties, 2, chunk);
        H5Dclose(H5Dcreate2(file, "/VTKHDF/Points", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT,
                            properties, H5P_DEFAULT));
        H5Pclose(properties);
        H5Sclose(space);
    });
    expect_refused({"points", path().string()}, "holds more than it can");
}

TEST_F(BrokenMesh, WhoseUnitIsSeveralTextsIsRefused) {
    fs::create_directories(out_);
    write(path(), {});
    alter([](hid_t file) {
        const hsize_t four = 4, texts = 500;
        const hid_t group = H5Gcreate2(file, "/VTKHDF/PointData", H5P_DEFAULT, H5P_DEFAULT,
                                       H5P_DEFAULT),
                    space = H5Screate_simple(1, &four, nullptr),
                    many = H5Screate_simple(1, &texts, nullptr), type = H5Tcopy(H5T_C_S1);
        H5Tset_size(type, H5T_VARIABLE);
        H5Tset_cset(type, H5T_CSET_UTF8);
        const hid_t data = H5Dcreate2(group, "T", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT,
                                      H5P_DEFAULT, H5P_DEFAULT),
                    unit = H5Acreate2(data, "units", type, many, H5P_DEFAULT, H5P_DEFAULT);
        const std::vector<const char*> units(texts, "K");
        H5Awrite(unit, type, units.data());
        H5Aclose(unit);
        H5Dclose(data);
        H5Tclose(type);
        H5Sclose(many);
        H5Sclose(space);
        H5Gclose(group);
    });
    expect_refused({"points", path().string()}, "is not one text");
}

TEST_F(BrokenMesh, ThatWasFoundByFuzzingEndsInOrder) {
    for (const char* target : {"program", "vtu"})
        for (const auto& entry :
             fs::directory_iterator(source_path("tests/fuzz/corpus") / target)) {
            const Finished run = crawford({"points", entry.path().string()});
            EXPECT_TRUE(run.status == 0 || run.status == 2) << entry.path() << run.output;
        }
}

}  // namespace
}  // namespace crawford
