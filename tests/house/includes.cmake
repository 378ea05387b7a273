# Who may know whom: fails when a file of `root` includes what its folder must not know.
#
#   cmake -D root=DIR -P includes.cmake
#
# solver and reference must not share a line of code, or the truth could not disagree with what it judges; reports knows
# neither. An include of ours is written "<folder>/...", never relative and never in angle brackets, so that this
# test and the include paths of the build see it; only tests name a header beside them as such.

set(base_may_know base)
set(solver_may_know base solver)
set(reference_may_know base reference)
set(reports_may_know base reports)
set(cases_may_know base solver reference reports cases)
set(program_may_know base solver reference reports cases program)
set(tests_may_know base solver reference reports tests)
set(folders base solver reference reports cases program tests)
list(JOIN folders "|" any_folder)

foreach(folder IN LISTS folders)
  list(JOIN ${folder}_may_know "|" known)
  file(GLOB_RECURSE files RELATIVE ${root} ${root}/${folder}/*.?pp ${root}/${folder}/*.h ${root}/${folder}/*.in)
  foreach(file IN LISTS files)
    set(directive_pattern "^[ \t]*(#|%:)[ \t]*(include_next|include|import)[ \t]*(.*)$")
    file(STRINGS ${root}/${file} directives REGEX "${directive_pattern}")
    foreach(directive IN LISTS directives)
      string(REGEX MATCH "${directive_pattern}" whole "${directive}")
      set(target "${CMAKE_MATCH_3}")
      if(target MATCHES "^\"(${known})/[^\"]*\"" AND NOT target MATCHES "\\.\\./")
        continue()
      endif()
      if(folder STREQUAL tests AND target MATCHES "^\"[^/\"]+\"")
        continue()
      endif()
      if(target MATCHES "^<[^>]*>" AND NOT target MATCHES "\\.\\./" AND NOT target MATCHES "^<(${any_folder})/")
        continue()
      endif()
      message(SEND_ERROR "${file}: ${directive}\n  ${folder}/ may include \"${known}/...\" and <libraries>, nothing else")
    endforeach()
  endforeach()
endforeach()
