# crawford_build_info(TARGET): compiles version, git revision, compiler and flags into TARGET. The revision is asked for at
# every build, and one small file is compiled anew when the answer has changed.

function(crawford_build_info target)
  set(generated ${PROJECT_BINARY_DIR}/generated/build_info.cpp)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}" flags)
  add_custom_target(build_info
    COMMAND ${CMAKE_COMMAND}
      -D template=${PROJECT_SOURCE_DIR}/base/build_info.cpp.in
      -D generated=${generated}
      -D source_dir=${PROJECT_SOURCE_DIR}
      -D version=${PROJECT_VERSION}
      -D "compiler=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
      -D "flags=${flags}"
      -P ${PROJECT_SOURCE_DIR}/cmake/write_build_info.cmake
    BYPRODUCTS ${generated}
    COMMENT "Asking git for the revision"
    VERBATIM)
  target_sources(${target} PRIVATE ${generated})
  add_dependencies(${target} build_info)
endfunction()
