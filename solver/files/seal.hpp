/// Files that can tell whether they are as they were written: one digest over the whole content.
///
/// It stands before the content in a block of 512 bytes, a size that HDF5 passes over (a "user block"): with h5py or
/// h5dump a sealed HDF5 file opens as any other.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace crawford {

/// Writes the content behind its seal, whole or not at all.
/// \throws InputError if the file cannot be written.
void write_sealed(const std::filesystem::path& path, std::string_view content);

/// The content, once its seal has been found right.
/// \throws InputError if the file cannot be read, has no seal, or any byte of it is not as it was
/// written.
std::string read_sealed(const std::filesystem::path& path);

}  // namespace crawford
