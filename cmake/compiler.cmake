# The language, the kind of build, and a compiler cache where there is one.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Every program names its own contents: by that records are told from those of another build.
add_link_options(LINKER:--build-id=sha1)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# What most files read, read once for each target: a quarter of the build.
function(crawford_precompile target)
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <span> <string> <utility> <vector>
    <fmt/format.h> <fmt/ranges.h> ${ARGN})
  # A compiler cache can only take part if the header stays visible to the preprocessor.
  if(CMAKE_CXX_COMPILER_LAUNCHER AND CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  endif()
endfunction()

# What our own code must pass, and nobody else's headers. GCC 12 sees an overlap in any std::string + std::string that it
# inlines (its bug 105651), so that one warning is off.
function(crawford_strict target)
  if(CRAWFORD_FUZZ)
    return()  # clang warns of other things; clang-tidy looks at them
  endif()
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
endfunction()
