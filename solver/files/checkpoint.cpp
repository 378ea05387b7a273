#include "solver/files/checkpoint.hpp"

#include <fmt/format.h>

#include <string>

#include "base/errors.hpp"
#include "solver/files/hdf5_file.hpp"
#include "solver/files/scene_difference.hpp"
#include "solver/files/seal.hpp"
#include "solver/step/state_fields.hpp"

namespace crawford {

namespace {

constexpr std::int64_t format_version = 1;

using Numbers = std::span<const double>;
using Shape = Hdf5File::Shape;

// How a value of a field becomes numbers and back.
template <class Value>
constexpr hsize_t components = 1;
template <>
constexpr hsize_t components<Vector> = 2;
template <>
constexpr hsize_t components<Deviator> = 3;

void append(std::vector<double>& numbers, double value) {
    numbers.push_back(value);
}
void append(std::vector<double>& numbers, const Vector& v) {
    numbers.insert(numbers.end(), {v.x(), v.y()});
}
void append(std::vector<double>& numbers, const Deviator& s) {
    numbers.insert(numbers.end(), {s.s11, s.s22, s.s12});
}

void take(const double* numbers, double& value) {
    value = numbers[0];
}
void take(const double* numbers, Vector& v) {
    v = {numbers[0], numbers[1]};
}
void take(const double* numbers, Deviator& s) {
    s = {numbers[0], numbers[1], numbers[2]};
}

void write(Hdf5File& file, const std::string& path, const SurfaceField& field,
           const std::string& units) {
    file.write(path, Numbers(field), {field.size()}, units);
}

template <class Value>
void write(Hdf5File& file, const std::string& path, const Lattice<Value>& field,
           const std::string& units) {
    if (field.empty()) return;
    std::vector<double> numbers;
    for (const Value& value : field.values()) append(numbers, value);
    file.write(path, Numbers(numbers),
               {hsize_t(field.columns()), hsize_t(field.rows()), components<Value>}, units);
}

std::string path_of_point(const std::string& path, size_t point) {
    return fmt::format("{}_{}", path, point);
}

/// A field of several points a cell: one data set for each.
template <class Value>
void write(Hdf5File& file, const std::string& path, const std::vector<Lattice<Value>>& points,
           const std::string& units) {
    for (size_t k = 0; k < points.size(); ++k)
        write(file, path_of_point(path, k), points[k], units);
}

void read(const Hdf5File& file, const std::string& path, SurfaceField& field) {
    field = file.read<double>(path);
}

template <class Value>
void read(const Hdf5File& file, const std::string& path, Lattice<Value>& field) {
    if (!file.contains(path)) return;
    const Shape shape = file.shape(path);
    if (shape.size() != 3 || shape[2] != components<Value>)
        throw InputError(path + " has a shape that no checkpoint has");
    const std::vector<double> numbers = file.read<double>(path);
    field = Lattice<Value>(static_cast<int>(shape[0]), static_cast<int>(shape[1]));
    for (size_t k = 0; k < field.values().size(); ++k)
        take(&numbers[k * components<Value>], field.values()[k]);
}

template <class Value>
void read(const Hdf5File& file, const std::string& path, std::vector<Lattice<Value>>& points) {
    for (size_t k = 0; file.contains(path_of_point(path, k)); ++k)
        read(file, path_of_point(path, k), points.emplace_back());
}

template <class Number>
Number read_one(const Hdf5File& file, const std::string& path) {
    const std::vector<Number> numbers = file.read<Number>(path);
    if (numbers.size() != 1) throw InputError(path + " is not one number");
    return numbers.front();
}

void write_state(Hdf5File& file, const std::string& group, const State& state) {
    const std::int64_t step = state.step;
    file.create_group(group);
    file.write(group + "/step", std::span(&step, 1), {}, "1");
    file.write(group + "/time", Numbers(&state.time, 1), {}, "s");
    file.write(group + "/length", Numbers(&state.length, 1), {}, "s");
    for_each_state_field([&](const auto& field) {
        write(file, fmt::format("{}/{}", group, field.name), field.of(state), field.unit);
    });
}

State read_state(const Hdf5File& file, const std::string& group) {
    State state;
    state.step = read_one<std::int64_t>(file, group + "/step");
    state.time = read_one<double>(file, group + "/time");
    // Earlier checkpoints have none: all their steps were the scene's.
    if (file.contains(group + "/length")) state.length = read_one<double>(file, group + "/length");
    for_each_state_field([&](const auto& field) {
        read(file, fmt::format("{}/{}", group, field.name), field.of(state));
    });
    return state;
}

/// With the state before it, where the scheme looks back that far.
State read_states(const Hdf5File& file) {
    State state = read_state(file, "/state");
    if (file.contains("/previous"))
        state.previous = std::make_shared<const State>(read_state(file, "/previous"));
    return state;
}

void write_window(Hdf5File& file, const std::vector<Sample>& window) {
    std::vector<double> times, values;
    for (const Sample& sample : window) {
        times.push_back(sample.time);
        values.push_back(sample.value);
    }
    if (window.empty()) return;
    file.create_group("/window");
    file.write("/window/time", Numbers(times), {times.size()}, "s");
    file.write("/window/value", Numbers(values), {values.size()}, "SI");
}

std::vector<Sample> read_window(const Hdf5File& file) {
    if (!file.contains("/window")) return {};
    const std::vector<double> times = file.read<double>("/window/time");
    const std::vector<double> values = file.read<double>("/window/value");
    if (values.size() != times.size()) throw InputError("/window has times without values");
    std::vector<Sample> window;
    for (size_t k = 0; k < times.size(); ++k) window.push_back({times[k], values[k]});
    return window;
}

void write_choice(Hdf5File& file, const StepChoice& choice) {
    const StepMemory& m = choice.memory;
    const std::vector<double> numbers{choice.next,         choice.limit, m.length,
                                      m.length_before,     m.fastest,    choice.count.shortest,
                                      choice.count.longest};
    const std::vector<std::int64_t> counts{choice.count.rejected, choice.count.failed};
    file.create_group("/steps");
    file.write("/steps/numbers", Numbers(numbers), {numbers.size()}, "SI");
    file.write("/steps/counts", std::span<const std::int64_t>(counts), {counts.size()}, "1");
    file.write("/steps/slope", Numbers(m.slope), {m.slope.size()}, "SI");
    file.write("/steps/curvature", Numbers(m.curvature), {m.curvature.size()}, "SI");
}

std::optional<StepChoice> read_choice(const Hdf5File& file) {
    if (!file.contains("/steps")) return {};
    const auto numbers = file.read<double>("/steps/numbers");
    const auto counts = file.read<std::int64_t>("/steps/counts");
    if (numbers.size() != 7 || counts.size() != 2)
        throw InputError("/steps has numbers that no checkpoint has");
    return StepChoice{.next = numbers[0],
                      .limit = numbers[1],
                      .memory = {.slope = file.read<double>("/steps/slope"),
                                 .curvature = file.read<double>("/steps/curvature"),
                                 .length = numbers[2],
                                 .length_before = numbers[3],
                                 .fastest = numbers[4]},
                      .count = {.rejected = counts[0],
                                .failed = counts[1],
                                .shortest = numbers[5],
                                .longest = numbers[6]}};
}

Hdf5File open_checkpoint(const std::filesystem::path& path) {
    Hdf5File file = Hdf5File::of(read_sealed(path), path);
    if (!file.contains("/crawford/checkpoint_format"))
        throw InputError(
            fmt::format("{} is no checkpoint; give one that `crawford burn` wrote", path.string()));
    const auto version = read_one<std::int64_t>(file, "/crawford/checkpoint_format");
    if (version != format_version)
        throw InputError(fmt::format("{} has checkpoint format {}; this program reads {}",
                                     path.string(), version, format_version));
    return file;
}

std::string scene_of(const Hdf5File& checkpoint) {
    return checkpoint.text_attribute("/crawford", "scene");
}

}  // namespace

std::filesystem::path checkpoint_file(const std::filesystem::path& directory,
                                      const std::string& name, long step) {
    return directory / fmt::format("{}_checkpoint_{:06d}.h5", name, step);
}

void save_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint,
                     const Provenance& provenance) {
    Hdf5File file = Hdf5File::create(path);
    file.create_group("/crawford");
    file.write("/crawford/checkpoint_format", std::span(&format_version, 1), {}, "1");
    file.set_attribute("/crawford", "scene", provenance.scene);
    file.set_attribute("/crawford", "version", provenance.version);
    file.set_attribute("/crawford", "revision", provenance.revision);
    write_state(file, "/state", checkpoint.state);
    if (checkpoint.state.previous) write_state(file, "/previous", *checkpoint.state.previous);
    write_window(file, checkpoint.memory.window);
    if (checkpoint.memory.choice) write_choice(file, *checkpoint.memory.choice);
    write_sealed(path, file.image());
}

bool is_checkpoint_of(const std::filesystem::path& path, const std::string& scene) {
    return !difference(scene_of(open_checkpoint(path)), scene);
}

Checkpoint load_checkpoint(const std::filesystem::path& path, const std::string& scene) {
    const Hdf5File file = open_checkpoint(path);
    if (const auto key = difference(scene_of(file), scene))
        throw InputError(
            fmt::format("{} is a checkpoint of another scene: {}; restart with the "
                        "scene it was written for",
                        path.string(), *key));
    return {read_states(file), {read_window(file), read_choice(file)}};
}

}  // namespace crawford
