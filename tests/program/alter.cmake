# Writes a copy of burn_rate.cpp by whose law everything burns 1 % too fast.
#
#   cmake -D sound=FILE -D altered=FILE -P alter.cmake

file(READ ${sound} text)
string(REPLACE "return material.pyrolysis_prefactor *" "return 1.01 * material.pyrolysis_prefactor *" changed "${text}")
if(changed STREQUAL text)
  message(FATAL_ERROR "${sound} has no law to alter")
endif()
file(WRITE ${altered} "${changed}")
