# The same bits on any machine. A fused multiply-add rounds once where a product and a sum round twice, and GCC fuses
# them by itself where the processor can (-march=native; any ARM). In the motion of hard discs such a difference grows with
# every collision until the pack is another one.
file(GLOB_RECURSE crawford_reproducible CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/solver/packing/*.cpp)
set_source_files_properties(${crawford_reproducible} PROPERTIES COMPILE_OPTIONS -ffp-contract=off)
