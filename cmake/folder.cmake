# One folder of the house is one library. Its headers are reached as "<folder>/...", through an include path of
# its own that holds nothing but that folder: what a target does not link, it cannot include.

function(crawford_own_include_path name)
  set(path ${PROJECT_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${path})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${name} ${path}/${name} SYMBOLIC)
  set(${name}_include_path ${path} PARENT_SCOPE)
endfunction()

function(crawford_finish target folder)
  target_include_directories(${target} PUBLIC ${${folder}_include_path})
  target_link_libraries(${target} PUBLIC ${ARGN})
  crawford_strict(${target})
  crawford_precompile(${target})
endfunction()

# crawford_folder(NAME DEPENDS targets...): all of NAME/ as the static library NAME.
function(crawford_folder name)
  cmake_parse_arguments(PARSE_ARGV 1 folder "" "" "DEPENDS")
  crawford_own_include_path(${name})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${name}/*.cpp)
  add_library(${name} STATIC ${sources})
  crawford_finish(${name} ${name} ${folder_DEPENDS})
endfunction()

# crawford_objects(NAME DEPENDS targets... BUT files...): all of NAME/, but these files, as objects. Not an archive, so that what registers itself is
# linked although nobody calls it.
function(crawford_objects name)
  cmake_parse_arguments(PARSE_ARGV 1 folder "" "" "DEPENDS;BUT")
  crawford_own_include_path(${name})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${name}/*.cpp)
  list(REMOVE_ITEM sources ${folder_BUT})
  add_library(${name} OBJECT ${sources})
  crawford_finish(${name} ${name} ${folder_DEPENDS})
endfunction()

# crawford_program(NAME SOURCES...): the program, with these sources in place of the files of the libraries that define the
# same.
function(crawford_program name)
  add_executable(${name} ${ARGN} $<TARGET_OBJECTS:program> $<TARGET_OBJECTS:cases>)
  target_link_libraries(${name} PRIVATE entries solver reference reports base CLI11::CLI11
    pugixml::pugixml ZLIB::ZLIB)
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
endfunction()
