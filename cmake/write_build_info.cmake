# Run at build time by build_info.cmake. configure_file leaves the file alone when nothing has changed.

execute_process(
  COMMAND git describe --always --dirty --abbrev=12 --exclude=*
  WORKING_DIRECTORY ${source_dir}
  OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE
  RESULT_VARIABLE failed ERROR_QUIET)
if(failed)
  set(revision "unknown")
endif()

# crawford_fingerprint(VARIABLE FOLDERS...): one hash over names and contents of all that is in the folders, but for
# results that are kept there.
function(crawford_fingerprint variable)
  list(TRANSFORM ARGN APPEND "/*")
  file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${source_dir} ${ARGN})
  list(FILTER files EXCLUDE REGEX "\\.json$")
  set(all "${compiler} ${flags}")
  foreach(file IN LISTS files)
    file(SHA256 ${source_dir}/${file} hash)
    string(APPEND all "${file} ${hash}\n")
  endforeach()
  string(SHA256 hash "${all}")
  string(SUBSTRING ${hash} 0 16 hash)
  set(${variable} ${hash} PARENT_SCOPE)
endfunction()

crawford_fingerprint(solver_fingerprint ${source_dir}/solver)
crawford_fingerprint(source_fingerprint
  ${source_dir}/base ${source_dir}/solver ${source_dir}/reference ${source_dir}/reports ${source_dir}/cases
  ${source_dir}/program)
configure_file(${template} ${generated} @ONLY)
