# Writes a ctest script with one test for each study of the catalogue, as the program itself lists them: a new study is
# a test without being named anywhere else. Run at build time.
#
#   cmake -D program=CRAWFORD -D out=DIR -D cores=N -D script=FILE -P studies.cmake

set(slow 30)  # [s]: a study that costs more is labelled so

execute_process(COMMAND ${program} list --studies OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" lines "${listed}")
set(tests "")
foreach(line IN LISTS lines)
  string(REGEX MATCH "^([^ ]+) ([0-9.e+]+)$" whole "${line}")
  set(name ${CMAKE_MATCH_1})
  set(labels verify)
  if(CMAKE_MATCH_2 GREATER slow)
    list(APPEND labels slow)
  endif()
  # A study takes all cores by itself.
  string(APPEND tests
    "add_test([[verify.${name}]] [[${program}]] verify ${name} --quiet --out [[${out}/${name}]])\n"
    "set_tests_properties([[verify.${name}]] PROPERTIES LABELS \"${labels}\" PROCESSORS ${cores} TIMEOUT 600)\n")
endforeach()
file(WRITE ${script} "${tests}")
