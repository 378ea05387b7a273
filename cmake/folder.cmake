# One folder of the house is one library. Its headers are reached as "<folder>/...", through an include path of
# its own that holds nothing but that folder: what a target does not link, it cannot include.

function(crawford_own_include_path name)
  set(path ${PROJECT_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${path})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${name} ${path}/${name} SYMBOLIC)
  set(${name}_include_path ${path} PARENT_SCOPE)
endfunction()

# crawford_folder(NAME DEPENDS targets...): all of NAME/ as the static library NAME.
function(crawford_folder name)
  cmake_parse_arguments(PARSE_ARGV 1 folder "" "" "DEPENDS")
  crawford_own_include_path(${name})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${name}/*.cpp)
  add_library(${name} STATIC ${sources})
  target_include_directories(${name} PUBLIC ${${name}_include_path})
  target_link_libraries(${name} PUBLIC ${folder_DEPENDS})
  crawford_strict(${name})
endfunction()

# crawford_program(PROGRAM NAME DEPENDS targets...): all of NAME/ as an executable. Not a library, so that what registers
# itself is linked although nobody calls it.
function(crawford_program program name)
  cmake_parse_arguments(PARSE_ARGV 2 folder "" "" "DEPENDS")
  crawford_own_include_path(${name})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${name}/*.cpp)
  add_executable(${program} ${sources})
  target_include_directories(${program} PRIVATE ${${name}_include_path})
  target_link_libraries(${program} PRIVATE ${folder_DEPENDS})
  crawford_strict(${program})
endfunction()
