# What programs for several ranks are built with and run by, if MPI is found: a target to link with, and tests.
find_package(MPI QUIET COMPONENTS CXX)
if(NOT MPI_CXX_FOUND)
  return()
endif()

if(NOT TARGET Bubble_relaxation_2_MPI)
  add_library(Bubble_relaxation_2_MPI INTERFACE)
  target_link_libraries(Bubble_relaxation_2_MPI INTERFACE MPI::MPI_CXX)
  target_compile_definitions(Bubble_relaxation_2_MPI INTERFACE OMPI_SKIP_MPICXX) # MPI's own C++ classes are not used
  if(TARGET Bubble_relaxation_2_core)
    add_library(Bubble_relaxation_2_ranks STATIC EXCLUDE_FROM_ALL
                ${CMAKE_CURRENT_LIST_DIR}/../src/Bubble_relaxation_2/ranks.cpp)
    target_link_libraries(Bubble_relaxation_2_ranks PUBLIC Bubble_relaxation_2_core MPI::MPI_CXX)
    target_compile_definitions(Bubble_relaxation_2_ranks PRIVATE OMPI_SKIP_MPICXX CGAL_NDEBUG
                               PUBLIC CGAL_BUBBLE_RELAXATION_2_COMPILED_RANKS)
    set_core_options(Bubble_relaxation_2_ranks)
    target_link_libraries(Bubble_relaxation_2_MPI INTERFACE Bubble_relaxation_2_ranks)
  endif()
endif()

# a test that runs a target by so many ranks: add_mpi_test(NAME RANKS TARGET [ARGUMENT...])
# waiting ranks yield: there are more of them than cores; and in a container they may not read each other's memory
function(add_mpi_test name ranks target)
  add_test(NAME ${name} COMMAND ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks} ${MPIEXEC_PREFLAGS}
                                $<TARGET_FILE:${target}> ${MPIEXEC_POSTFLAGS} ${ARGN})
  set_tests_properties(${name} PROPERTIES TIMEOUT 600 PROCESSORS 2 ENVIRONMENT
    "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;OMPI_MCA_rmaps_base_oversubscribe=1;\
OMPI_MCA_mpi_yield_when_idle=1;OMPI_MCA_btl_vader_single_copy_mechanism=none")
endfunction()
