/// HDF5 files through a handful of calls. What the library would print on stderr becomes an
/// InputError that names the file, the data set and the reason.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace crawford {

/// Owns one HDF5 identifier.
class Hdf5Handle {
public:
    using Closer = herr_t (*)(hid_t);

    Hdf5Handle() = default;
    Hdf5Handle(hid_t id, Closer closer) : id_(id), closer_(closer) {}
    Hdf5Handle(Hdf5Handle&& other) noexcept
        : id_(std::exchange(other.id_, H5I_INVALID_HID)), closer_(other.closer_) {}
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    ~Hdf5Handle() { close(); }

    hid_t id() const { return id_; }
    bool valid() const { return id_ >= 0; }
    bool close();  ///< false if it fails

private:
    hid_t id_ = H5I_INVALID_HID;
    Closer closer_ = nullptr;
};

class Hdf5File {
public:
    using Shape = std::vector<hsize_t>;

    /// A new file, in memory until it is published under `path`.
    static Hdf5File create(const std::filesystem::path& path);
    /// To be read.
    /// \throws InputError if there is no such file or it is no HDF5 file.
    static Hdf5File open(const std::filesystem::path& path);
    /// The same of a file whose bytes are here already; `path` is for messages. They are copied.
    static Hdf5File of(std::string_view image, const std::filesystem::path& path);

    void create_group(const std::string& path);

    /// Writes numbers of a shape, last index fastest, compressed, with their units ("1" for a pure
    /// number). Number is double, std::int64_t or std::uint8_t.
    template <class Number>
    void write(const std::string& path, std::span<const Number> numbers, const Shape& shape,
               const std::string& units);

    /// Text of any length.
    void set_attribute(const std::string& object, const std::string& name, const std::string& text);
    void set_attribute(const std::string& object, const std::string& name,
                       std::span<const std::int64_t> numbers);
    /// ASCII of fixed length, the only kind of text that VTK's reader accepts.
    void set_fixed_attribute(const std::string& object, const std::string& name,
                             const std::string& text);

    bool contains(const std::string& path) const;
    Shape shape(const std::string& path) const;
    template <class Number>
    std::vector<Number> read(const std::string& path) const;
    /// Of the links in a group.
    std::vector<std::string> names(const std::string& group) const;
    std::string text_attribute(const std::string& object, const std::string& name) const;
    bool has_attribute(const std::string& object, const std::string& name) const;

    /// The bytes of the file.
    std::string image() const;

    /// Writes the file whole, in place of what was there. HDF5 itself never touches the disk,
    /// because after a failed write (a full disk) it cannot even be left in order.
    /// \throws InputError if it cannot be written; nothing is then left under its name.
    void publish();

private:
    enum class Purpose { read, write };
    Hdf5File(std::filesystem::path path, Purpose purpose);

    Hdf5Handle checked(hid_t id, Hdf5Handle::Closer closer, const std::string& object) const;
    void check(bool success, const std::string& object) const;
    Hdf5Handle open_dataset(const std::string& path) const;
    /// A broken shape asks for any amount of memory.
    void check_room(hid_t dataset, const std::string& path) const;

    std::filesystem::path path_;
    Purpose purpose_;
    Hdf5Handle file_;
};

}  // namespace crawford
