# What Crawford stands on, all of it in Debian 12 (`make deps`).

find_package(Eigen3 3.4 REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(pugixml REQUIRED)
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)
find_package(OpenMP REQUIRED)
find_library(UDUNITS_LIBRARY udunits2 REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(OPENBLAS_LIBRARY openblas REQUIRED)

# What every folder may use.
add_library(crawford_libraries INTERFACE)
target_link_libraries(crawford_libraries INTERFACE
  Eigen3::Eigen Boost::headers fmt::fmt nlohmann_json::nlohmann_json Threads::Threads)

# What the solver needs besides: linear algebra, files, units. CHOLMOD takes whatever BLAS the system has chosen, and
# the reference BLAS is three times slower: OpenBLAS is linked before it, and even though no symbol of ours asks for it,
# so that the loader finds the BLAS of OpenBLAS first.
add_library(crawford_solver_libraries INTERFACE)
target_include_directories(crawford_solver_libraries SYSTEM INTERFACE
  ${CHOLMOD_INCLUDE} ${HDF5_C_INCLUDE_DIRS})
target_link_libraries(crawford_solver_libraries INTERFACE
  crawford_libraries
  -Wl,--push-state,--no-as-needed ${OPENBLAS_LIBRARY} -Wl,--pop-state
  OpenMP::OpenMP_CXX ${CHOLMOD_LIBRARY} ${HDF5_C_LIBRARIES} ${UDUNITS_LIBRARY} tomlplusplus::tomlplusplus)
