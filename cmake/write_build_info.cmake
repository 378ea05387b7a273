# Run at build time by build_info.cmake. configure_file leaves the file alone when nothing has changed.

execute_process(
  COMMAND git describe --always --dirty --abbrev=12 --exclude=*
  WORKING_DIRECTORY ${source_dir}
  OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE
  RESULT_VARIABLE failed ERROR_QUIET)
if(failed)
  set(revision "unknown")
endif()
configure_file(${template} ${generated} @ONLY)
