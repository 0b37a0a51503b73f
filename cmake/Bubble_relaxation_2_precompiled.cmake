# Half of the time that a program here takes to compile goes into the headers of CGAL and of the relaxation, which
# nearly all include: these are compiled once, with the given libraries, for the programs of some folders that have the
# same options. (That examples include what they use is seen where they are compiled for their warnings.) For a few
# programs that would take longer than it saves.
#   reuse_precompiled_headers(NAME FOLDERS... LIBRARIES... HEADERS...)
function(reuse_precompiled_headers name)
  cmake_parse_arguments(argument "" "" "FOLDERS;LIBRARIES;HEADERS" ${ARGN})
  set(targets)
  foreach(folder IN LISTS argument_FOLDERS)
    get_property(of_folder DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    list(APPEND targets ${of_folder})
  endforeach()
  list(LENGTH targets number)
  if(number LESS 6)
    return()
  endif()
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE ${argument_LIBRARIES})
  target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>) # for ccache
  list(TRANSFORM argument_HEADERS REPLACE "(.+)" "<\\1>")
  target_precompile_headers(${name} PRIVATE ${argument_HEADERS})
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    get_target_property(libraries ${target} LINK_LIBRARIES)
    if(type STREQUAL "EXECUTABLE" AND NOT libraries MATCHES "TBB") # which defines macros that these headers look for
      target_precompile_headers(${target} REUSE_FROM ${name})
      target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    endif()
  endforeach()
endfunction()
