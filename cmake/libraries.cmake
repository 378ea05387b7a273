# What Crawford stands on, all of it in Debian (see `make deps`).

find_package(Eigen3 REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C HL)
find_package(PkgConfig REQUIRED)
pkg_check_modules(UDUNITS REQUIRED IMPORTED_TARGET udunits)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)

# Headers and small libraries that any folder may use.
add_library(crawford_headers INTERFACE)
target_include_directories(crawford_headers SYSTEM INTERFACE ${EIGEN3_INCLUDE_DIRS})
target_link_libraries(crawford_headers INTERFACE Eigen3::Eigen Boost::headers fmt::fmt nlohmann_json::nlohmann_json)

# What the solver needs besides: linear algebra, files, units.
add_library(crawford_libraries INTERFACE)
target_include_directories(crawford_libraries SYSTEM INTERFACE ${CHOLMOD_INCLUDE} ${HDF5_C_INCLUDE_DIRS})
target_link_libraries(crawford_libraries INTERFACE
  crawford_headers ${CHOLMOD_LIBRARY} ${HDF5_C_LIBRARIES} ${HDF5_C_HL_LIBRARIES}
  tomlplusplus::tomlplusplus spdlog::spdlog PkgConfig::UDUNITS)
