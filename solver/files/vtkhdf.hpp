/// Snapshots as VTKHDF: HDF5 to h5py, an unstructured grid of quadrilaterals to VTK and ParaView.
#pragma once

#include <filesystem>

#include "solver/files/provenance.hpp"
#include "solver/files/snapshot.hpp"

namespace crawford {

/// Writes VTKHDF 1.0. The name should end in ".hdf": ParaView 5.11 does not know ".vtkhdf". Vectors
/// have three components, tensors six (XX YY ZZ XY YZ XZ), every data set its `units`; where it
/// comes from stands in the group /crawford.
/// \throws InputError if the file cannot be written; nothing is then left under its name.
void write_vtkhdf(const std::filesystem::path& path, const Snapshot& snapshot,
                  const Provenance& provenance);

}  // namespace crawford
