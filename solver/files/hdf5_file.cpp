#include "solver/files/hdf5_file.hpp"

#include <fmt/format.h>

#include <concepts>
#include <new>
#include <random>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/room.hpp"

namespace crawford {

namespace {

template <class Number>
hid_t native_type() {
    if constexpr (std::same_as<Number, double>) {
        return H5T_NATIVE_DOUBLE;
    } else if constexpr (std::same_as<Number, std::int64_t>) {
        return H5T_NATIVE_INT64;
    } else {
        static_assert(std::same_as<Number, std::uint8_t>);
        return H5T_NATIVE_UINT8;
    }
}

/// The first, most specific entry of HDF5's error stack; of a failed system call only its message.
std::string reason() {
    std::string text;
    H5Ewalk2(
        H5E_DEFAULT, H5E_WALK_UPWARD,
        [](unsigned, const H5E_error2_t* entry, void* result) -> herr_t {
            *static_cast<std::string*>(result) = entry->desc;
            return 1;
        },
        &text);
    const std::string marker = "error message = '";
    const size_t begin = text.find(marker);
    if (begin == std::string::npos) return text;
    const size_t message = begin + marker.size();
    return text.substr(message, text.find('\'', message) - message);
}

bool is_out_of_memory() {
    bool found = false;
    H5Ewalk2(
        H5E_DEFAULT, H5E_WALK_UPWARD,
        [](unsigned, const H5E_error2_t* entry, void* result) -> herr_t {
            *static_cast<bool*>(result) |=
                entry->min_num == H5E_CANTALLOC || entry->min_num == H5E_NOSPACE;
            return 0;
        },
        &found);
    return found;
}

hsize_t product(const Hdf5File::Shape& shape) {
    hsize_t size = 1;
    for (const hsize_t extent : shape) size *= extent;
    return size;
}

/// One chunk a data set: fields are read whole, and a single stream compresses best.
void compress(hid_t properties, const Hdf5File::Shape& shape) {
    constexpr unsigned level = 4;
    H5Pset_chunk(properties, int(shape.size()), shape.data());
    H5Pset_shuffle(properties);
    H5Pset_deflate(properties, level);
}

constexpr size_t increment = 1 << 20;  ///< of a file in memory that grows [bytes]

Hdf5Handle text_type() {
    Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.id(), H5T_VARIABLE);
    H5Tset_cset(type.id(), H5T_CSET_UTF8);
    return type;
}

}  // namespace

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& other) noexcept {
    if (this != &other) {
        close();
        id_ = std::exchange(other.id_, H5I_INVALID_HID);
        closer_ = other.closer_;
    }
    return *this;
}

bool Hdf5Handle::close() {
    if (!valid()) return true;
    return closer_(std::exchange(id_, H5I_INVALID_HID)) >= 0;
}

Hdf5File::Hdf5File(std::filesystem::path path, Purpose purpose)
    : path_(std::move(path)), purpose_(purpose) {
    // HDF5 1.10 uses the cache of a file even where it found no memory for it, and ends by a signal.
    look_for_room(for_a_library);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5File Hdf5File::create(const std::filesystem::path& path) {
    Hdf5File file(path, Purpose::write);
    const Hdf5Handle in_memory = file.checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "");
    file.check(H5Pset_fapl_core(in_memory.id(), increment, false) >= 0, "");
    file.file_ = file.checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, in_memory.id()),
                              H5Fclose, "");
    return file;
}

Hdf5File Hdf5File::open(const std::filesystem::path& path) {
    Hdf5File file(path, Purpose::read);
    file.file_ = file.checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "");
    return file;
}

Hdf5File Hdf5File::of(std::string_view image, const std::filesystem::path& path) {
    Hdf5File file(path, Purpose::read);
    const Hdf5Handle in_memory = file.checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "");
    file.check(H5Pset_fapl_core(in_memory.id(), increment, false) >= 0, "");
    // A name that no file on the disk has, as HDF5 asks, and no other file in memory: those it would share.
    std::random_device random;
    const std::string name = fmt::format("{}.{:08x}{:08x}", path.string(), random(), random());
    std::string copy(image);  // HDF5 asks for bytes that it may change, and copies them
    file.check(H5Pset_file_image(in_memory.id(), copy.data(), copy.size()) >= 0, "");
    file.file_ = file.checked(H5Fopen(name.c_str(), H5F_ACC_RDONLY, in_memory.id()), H5Fclose, "");
    return file;
}

void Hdf5File::check(bool success, const std::string& object) const {
    if (success) return;
    // What is read may ask for any amount: then it is the file that is wrong.
    if (purpose_ == Purpose::write && is_out_of_memory()) throw std::bad_alloc();
    const char* const purpose = purpose_ == Purpose::write ? "write" : "read";
    throw InputError(fmt::format("cannot {} {}{}{}: {}", purpose, object,
                                 object.empty() ? "" : " of ", path_.string(), reason()));
}

Hdf5Handle Hdf5File::checked(hid_t id, Hdf5Handle::Closer closer, const std::string& object) const {
    check(id >= 0, object);
    return {id, closer};
}

void Hdf5File::create_group(const std::string& path) {
    checked(H5Gcreate2(file_.id(), path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
            path);
}

template <class Number>
void Hdf5File::write(const std::string& path, std::span<const Number> numbers, const Shape& shape,
                     const std::string& units) {
    if (numbers.size() != product(shape))
        throw std::invalid_argument(path + ": the numbers do not fill the shape");
    const Hdf5Handle space =
        checked(H5Screate_simple(int(shape.size()), shape.data(), nullptr), H5Sclose, path);
    const Hdf5Handle properties = checked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path);
    // Files of the same numbers are the same, byte by byte, whenever they were written.
    check(H5Pset_obj_track_times(properties.id(), false) >= 0, path);
    if (numbers.size() > 1) compress(properties.id(), shape);
    Hdf5Handle dataset = checked(H5Dcreate2(file_.id(), path.c_str(), native_type<Number>(),
                                            space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
                                 H5Dclose, path);
    check(H5Dwrite(dataset.id(), native_type<Number>(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                   numbers.data()) >= 0,
          path);
    check(dataset.close(), path);
    set_attribute(path, "units", units);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name,
                             const std::string& text) {
    const Hdf5Handle space = checked(H5Screate(H5S_SCALAR), H5Sclose, object);
    const Hdf5Handle type = text_type();
    const Hdf5Handle attribute =
        checked(H5Acreate_by_name(file_.id(), object.c_str(), name.c_str(), type.id(), space.id(),
                                  H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                H5Aclose, object);
    const char* characters = text.c_str();
    check(H5Awrite(attribute.id(), type.id(), &characters) >= 0, object);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name,
                             std::span<const std::int64_t> numbers) {
    const hsize_t size = numbers.size();
    const Hdf5Handle space = checked(H5Screate_simple(1, &size, nullptr), H5Sclose, object);
    const Hdf5Handle attribute =
        checked(H5Acreate_by_name(file_.id(), object.c_str(), name.c_str(), H5T_NATIVE_INT64,
                                  space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                H5Aclose, object);
    check(H5Awrite(attribute.id(), H5T_NATIVE_INT64, numbers.data()) >= 0, object);
}

void Hdf5File::set_fixed_attribute(const std::string& object, const std::string& name,
                                   const std::string& text) {
    const Hdf5Handle space = checked(H5Screate(H5S_SCALAR), H5Sclose, object);
    const Hdf5Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose, object);
    check(H5Tset_size(type.id(), text.size()) >= 0, object);
    check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD) >= 0, object);
    const Hdf5Handle attribute =
        checked(H5Acreate_by_name(file_.id(), object.c_str(), name.c_str(), type.id(), space.id(),
                                  H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                H5Aclose, object);
    check(H5Awrite(attribute.id(), type.id(), text.data()) >= 0, object);
}

bool Hdf5File::contains(const std::string& path) const {
    return H5Lexists(file_.id(), path.c_str(), H5P_DEFAULT) > 0;
}

Hdf5Handle Hdf5File::open_dataset(const std::string& path) const {
    return checked(H5Dopen2(file_.id(), path.c_str(), H5P_DEFAULT), H5Dclose, path);
}

Hdf5File::Shape Hdf5File::shape(const std::string& path) const {
    const Hdf5Handle dataset = open_dataset(path);
    const Hdf5Handle space = checked(H5Dget_space(dataset.id()), H5Sclose, path);
    const int rank = H5Sget_simple_extent_ndims(space.id());
    check(rank >= 0, path);
    Shape shape(static_cast<size_t>(rank));
    check(H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr) >= 0, path);
    return shape;
}

void Hdf5File::check_room(hid_t dataset, const std::string& path) const {
    // What deflate can reach, and numbers that were never written, which take no room.
    constexpr double densest = 1032.0, unwritten = 1e6;
    double count = 1.0;
    for (const hsize_t size : shape(path)) count *= double(size);
    if (count > unwritten + densest * double(H5Dget_storage_size(dataset)))
        throw InputError(fmt::format("cannot read {} of {}: it says that it holds more than it can",
                                     path, path_.string()));
}

template <class Number>
std::vector<Number> Hdf5File::read(const std::string& path) const {
    const Hdf5Handle dataset = open_dataset(path);
    check_room(dataset.id(), path);
    std::vector<Number> numbers(product(shape(path)));
    check(H5Dread(dataset.id(), native_type<Number>(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                  numbers.data()) >= 0,
          path);
    return numbers;
}

std::string Hdf5File::text_attribute(const std::string& object, const std::string& name) const {
    const Hdf5Handle attribute =
        checked(H5Aopen_by_name(file_.id(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                H5Aclose, object);
    const Hdf5Handle space = checked(H5Aget_space(attribute.id()), H5Sclose, object);
    if (H5Sget_simple_extent_npoints(space.id()) != 1)
        throw InputError(fmt::format("cannot read {} of {}: its attribute {} is not one text",
                                     object, path_.string(), name));
    const Hdf5Handle type = text_type();
    char* characters = nullptr;
    check(H5Aread(attribute.id(), type.id(), &characters) >= 0, object);
    std::string text = characters ? characters : "";
    H5free_memory(characters);
    return text;
}

bool Hdf5File::has_attribute(const std::string& object, const std::string& name) const {
    return H5Aexists_by_name(file_.id(), object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5File::names(const std::string& group) const {
    const Hdf5Handle opened =
        checked(H5Gopen2(file_.id(), group.c_str(), H5P_DEFAULT), H5Gclose, group);
    H5G_info_t info{};
    check(H5Gget_info(opened.id(), &info) >= 0, group);
    std::vector<std::string> names;
    for (hsize_t k = 0; k < info.nlinks; ++k) {
        const auto name_at = [&](char* text, size_t room) {
            const ssize_t size = H5Lget_name_by_idx(opened.id(), ".", H5_INDEX_NAME, H5_ITER_INC, k,
                                                    text, room, H5P_DEFAULT);
            check(size >= 0, group);
            return size_t(size);
        };
        std::string name(name_at(nullptr, 0) + 1, '\0');
        name.resize(name_at(name.data(), name.size()));
        names.push_back(std::move(name));
    }
    return names;
}

std::string Hdf5File::image() const {
    check(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL) >= 0, "");
    const ssize_t size = H5Fget_file_image(file_.id(), nullptr, 0);
    check(size >= 0, "");
    std::string image(static_cast<size_t>(size), '\0');
    check(H5Fget_file_image(file_.id(), image.data(), image.size()) == size, "");
    return image;
}

void Hdf5File::publish() {
    write_file(path_, image());
}

template void Hdf5File::write(const std::string&, std::span<const double>, const Shape&,
                              const std::string&);
template void Hdf5File::write(const std::string&, std::span<const std::int64_t>, const Shape&,
                              const std::string&);
template void Hdf5File::write(const std::string&, std::span<const std::uint8_t>, const Shape&,
                              const std::string&);
template std::vector<double> Hdf5File::read(const std::string&) const;
template std::vector<std::int64_t> Hdf5File::read(const std::string&) const;
template std::vector<std::uint8_t> Hdf5File::read(const std::string&) const;

}  // namespace crawford
