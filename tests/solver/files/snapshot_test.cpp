// Snapshots: the right numbers at the right points, in the shapes that VTKHDF asks for.
#include <array>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "solver/files/hdf5_file.hpp"
#include "solver/files/snapshot_series.hpp"
#include "solver/files/vtkhdf.hpp"
#include "tests/solver/scratch.hpp"

namespace crawford {

namespace {

const Provenance provenance{"title = \"t\"\n", "1.2.3", "abcdef"};

Domain domain(int nx, bool half = false) {
    return {.width = 6.0, .depth = 4.0, .nx = nx, .ny = 4, .clustering = 0.0, .half = half};
}

/// A state whose values tell their place: T = 100 i + j, v = (i, j), shift (0.25, 0), phi = -i.
State telling_state(const Grid& grid) {
    const int columns = grid.node_columns(), rows = grid.rows() + 1;
    State state;
    state.step = 42;
    state.time = 0.125;
    state.temperature = NodeField(columns, rows);
    state.velocity = NodeVectors(columns, rows);
    state.reference_shift = NodeVectors(columns, rows, Vector(0.25, 0.0));
    state.stress = StressField(grid.cell_columns(), grid.rows(), 4);
    for (int i = 0; i < columns; ++i) {
        state.surface.push_back(-i);
        for (int j = 0; j < rows; ++j) {
            state.temperature(i, j) = 100.0 * i + j;
            state.velocity(i, j) = Vector(i, j);
        }
    }
    return state;
}

/// All fields, the mean stress of cell (i, j) being s11 = 4, s22 = 8, s12 = 2, p = 10 + i.
Snapshot telling_snapshot(const Grid& grid) {
    State state = telling_state(grid);
    const int columns = grid.cell_columns(), rows = grid.rows();
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) {
            state.stress.pressure(i, j) = 10.0 + i;
            for (int point = 0; point < 4; ++point)
                state.stress.deviator[size_t(point)](i, j) = {point * 8.0 / 3.0, 8.0, 2.0};
        }
    Snapshot snapshot = collect_snapshot(grid, state);
    snapshot.material_indicator = NodeField(columns + 1, rows + 1, -1.0);
    snapshot.material = CellField(columns, rows, 0.5);
    snapshot.strain = Lattice<std::array<double, 3>>(columns, rows, {1.0, 2.0, 3.0});
    snapshot.strain_norm = CellField(columns, rows, 7.0);
    return snapshot;
}

class OutputSnapshot : public OutputTest {
protected:
    Hdf5File written(const Snapshot& snapshot) const {
        write_vtkhdf(directory / "s.hdf", snapshot, provenance);
        return Hdf5File::open(directory / "s.hdf");
    }
    std::vector<double> first(const Hdf5File& file, const std::string& path, size_t count) const {
        auto numbers = file.read<double>("/VTKHDF/" + path);
        numbers.resize(count);
        return numbers;
    }
    nlohmann::json series() const {
        return nlohmann::json::parse(content(directory / "run.hdf.series")).at("files");
    }
};

TEST_F(OutputSnapshot, ClosesThePeriodWithTheFirstColumn) {
    const Grid grid(domain(3));
    const Snapshot snapshot = collect_snapshot(grid, telling_state(grid));
    ASSERT_EQ(snapshot.position.columns(), 4);
    EXPECT_EQ(snapshot.position(0, 4), Vector(-3.0, 0.0));
    EXPECT_EQ(snapshot.position(2, 0), Vector(1.0, -4.0 - 2.0));  // the surface is at -2 there
    EXPECT_EQ(snapshot.position(3, 4), Vector(3.0, 0.0));
    EXPECT_EQ(snapshot.temperature(2, 3), 203.0);
    EXPECT_EQ(snapshot.temperature(3, 3), 3.0);
    EXPECT_EQ(snapshot.reference_map(3, 4), Vector(3.25, 0.0)) << "xi goes on with the period";
}

TEST_F(OutputSnapshot, HasTheLastColumnOfItsOwnBetweenMirrors) {
    const Grid grid(domain(6, true));
    const Snapshot snapshot = collect_snapshot(grid, telling_state(grid));
    ASSERT_EQ(snapshot.position.columns(), 4);
    EXPECT_EQ(snapshot.position(3, 4), Vector(3.0, -3.0));
    EXPECT_EQ(snapshot.temperature(3, 3), 303.0);
}

TEST_F(OutputSnapshot, WritesTheMeshThatVtkExpects) {
    const Grid grid(domain(3));
    const Hdf5File file = written(telling_snapshot(grid));
    EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/NumberOfPoints"), std::vector<std::int64_t>{20});
    EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/NumberOfCells"), std::vector<std::int64_t>{12});
    EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/NumberOfConnectivityIds"),
              std::vector<std::int64_t>{48});
    EXPECT_EQ(file.shape("/VTKHDF/Points"), (Hdf5File::Shape{20, 3}));
    EXPECT_EQ(file.shape("/VTKHDF/Offsets"), Hdf5File::Shape{13});
    EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/Offsets").back(), 48);
    EXPECT_EQ(file.read<std::uint8_t>("/VTKHDF/Types"), std::vector<std::uint8_t>(12, 9));
}

TEST_F(OutputSnapshot, TurnsEveryCellCounterclockwise) {
    const Grid grid(domain(3));
    const Hdf5File file = written(telling_snapshot(grid));
    const auto corners = file.read<std::int64_t>("/VTKHDF/Connectivity");
    const auto points = file.read<double>("/VTKHDF/Points");
    for (size_t cell = 0; cell < corners.size(); cell += 4) {
        double twice_area = 0.0;
        for (size_t k = 0; k < 4; ++k) {
            const auto a = size_t(3 * corners[cell + k]),
                       b = size_t(3 * corners[cell + (k + 1) % 4]);
            twice_area += points[a] * points[b + 1] - points[b] * points[a + 1];
        }
        EXPECT_DOUBLE_EQ(twice_area, 2.0 * 2.0 * 1.0);  // parallelograms dx = 2, height 1
    }
}

TEST_F(OutputSnapshot, WritesComponentsInVtkOrder) {
    const Grid grid(domain(3));
    const Hdf5File file = written(telling_snapshot(grid));
    using Numbers = std::vector<double>;
    EXPECT_EQ(file.shape("/VTKHDF/CellData/stress"), (Hdf5File::Shape{12, 6}));
    // XX YY ZZ XY YZ XZ; the mean of the deviators is (4, 8, -12), the pressure 10.
    EXPECT_EQ(first(file, "CellData/stress", 6), (Numbers{-6.0, -2.0, -22.0, 2.0, 0.0, 0.0}));
    EXPECT_EQ(first(file, "CellData/strain", 6), (Numbers{1.0, 2.0, 0.0, 3.0, 0.0, 0.0}));
    EXPECT_EQ(first(file, "PointData/velocity", 6), (Numbers{0.0, 0.0, 0.0, 0.0, 1.0, 0.0}));
    EXPECT_EQ(first(file, "PointData/reference_map", 3), (Numbers{-2.75, -4.0, 0.0}));
    EXPECT_EQ(first(file, "PointData/temperature", 6), (Numbers{0.0, 1.0, 2.0, 3.0, 4.0, 100.0}));
    EXPECT_EQ(first(file, "CellData/pressure", 5), (Numbers{10.0, 10.0, 10.0, 10.0, 11.0}));
}

TEST_F(OutputSnapshot, GivesEveryDataSetItsUnits) {
    const Hdf5File file = written(telling_snapshot(Grid(domain(3))));
    const std::vector<std::array<std::string, 2>> expected = {
        {"/VTKHDF/Points", "m"},
        {"/VTKHDF/Connectivity", "1"},
        {"/VTKHDF/Types", "1"},
        {"/VTKHDF/PointData/temperature", "K"},
        {"/VTKHDF/PointData/velocity", "m/s"},
        {"/VTKHDF/PointData/reference_map", "m"},
        {"/VTKHDF/PointData/material_indicator", "1"},
        {"/VTKHDF/CellData/stress", "Pa"},
        {"/VTKHDF/CellData/pressure", "Pa"},
        {"/VTKHDF/CellData/strain", "1"},
        {"/VTKHDF/CellData/strain_norm", "1"},
        {"/VTKHDF/CellData/material", "1"},
        {"/crawford/time", "s"},
        {"/crawford/step", "1"}};
    for (const auto& [path, units] : expected)
        EXPECT_EQ(file.text_attribute(path, "units"), units) << path;
}

// VTK 9.2 takes the type from a fixed-length ASCII string only.
TEST_F(OutputSnapshot, NamesItsTypeInTheOnlyWayVtkReads) {
    written(telling_snapshot(Grid(domain(3))));
    const Hdf5Handle file(H5Fopen((directory / "s.hdf").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
                          H5Fclose);
    const Hdf5Handle attribute(
        H5Aopen_by_name(file.id(), "/VTKHDF", "Type", H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
    EXPECT_EQ(H5Tis_variable_str(type.id()), 0);
    EXPECT_EQ(H5Tget_cset(type.id()), H5T_CSET_ASCII);
    std::string text(H5Tget_size(type.id()), '?');
    H5Aread(attribute.id(), type.id(), text.data());
    EXPECT_EQ(text, "UnstructuredGrid");
}

TEST_F(OutputSnapshot, SaysWhereItComesFrom) {
    const Hdf5File file = written(telling_snapshot(Grid(domain(3))));
    EXPECT_EQ(file.text_attribute("/crawford", "scene"), provenance.scene);
    EXPECT_EQ(file.text_attribute("/crawford", "version"), provenance.version);
    EXPECT_EQ(file.text_attribute("/crawford", "revision"), provenance.revision);
    EXPECT_EQ(file.read<double>("/crawford/time"), std::vector<double>{0.125});
    EXPECT_EQ(file.read<std::int64_t>("/crawford/step"), std::vector<std::int64_t>{42});
}

TEST_F(OutputSnapshot, OfAThermalColumnHoldsNoMechanics) {
    const Grid grid(domain(1));
    State state = telling_state(grid);
    state.velocity = {};
    state.reference_shift = {};
    state.stress = {};
    const Hdf5File file = written(collect_snapshot(grid, state));
    EXPECT_EQ(file.shape("/VTKHDF/Points"), (Hdf5File::Shape{10, 3}));
    EXPECT_TRUE(file.contains("/VTKHDF/PointData/temperature"));
    for (const char* absent : {"PointData/velocity", "PointData/reference_map", "CellData/stress",
                               "CellData/pressure", "CellData/strain", "CellData/strain_norm"})
        EXPECT_FALSE(file.contains(std::string("/VTKHDF/") + absent)) << absent;
}

TEST_F(OutputSnapshot, ThatCannotBeWrittenLeavesNothing) {
    const Snapshot snapshot = telling_snapshot(Grid(domain(3)));
    put(directory / "taken", "a file");
    EXPECT_THROW(write_vtkhdf(directory / "taken" / "s.hdf", snapshot, provenance), InputError);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory), {}), 1);
}

TEST_F(OutputSnapshot, IsListedInTheSeriesWithItsTime) {
    SnapshotSeries writer(directory, "run", provenance);
    Snapshot snapshot = telling_snapshot(Grid(domain(3)));
    for (const long step : {0, 42, 42}) {
        snapshot.step = step;
        snapshot.time = 0.1 * double(step);
        writer.write(snapshot);
    }
    EXPECT_EQ(series(), nlohmann::json::parse(R"([{"name": "run_000000.hdf", "time": 0.0},
                                                  {"name": "run_000042.hdf", "time": 4.2}])"));
    EXPECT_TRUE(std::filesystem::exists(directory / "run_000042.hdf"));
}

TEST_F(OutputSnapshot, AfterTheRestartIsDroppedFromTheSeries) {
    Snapshot snapshot = telling_snapshot(Grid(domain(3)));
    const auto write = [&](SnapshotSeries& writer, long step) {
        snapshot.step = step;
        snapshot.time = 0.1 * double(step);
        writer.write(snapshot);
    };
    SnapshotSeries first(directory, "run", provenance);
    for (const long step : {1, 2, 3, 4}) write(first, step);
    SnapshotSeries second(directory, "run", provenance);
    second.resume(0.1 * 2.0);
    write(second, 5);
    std::vector<std::string> names;
    for (const auto& entry : series()) names.push_back(entry.at("name"));
    EXPECT_EQ(names,
              (std::vector<std::string>{"run_000001.hdf", "run_000002.hdf", "run_000005.hdf"}));
}

TEST_F(OutputSnapshot, SeriesThatIsDamagedIsRefused) {
    put(directory / "run.hdf.series", "{\"files\": [");
    SnapshotSeries writer(directory, "run", provenance);
    EXPECT_THROW(writer.resume(1.0), InputError);
}

}  // namespace

}  // namespace crawford
