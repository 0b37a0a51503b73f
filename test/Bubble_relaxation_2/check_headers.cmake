# Compiles each header alone, and all public ones together, by CXX with FLAGS. HEADERS: relative to a directory of these;
# SCRATCH: a directory for what is compiled; PRECOMPILED: headers of CGAL that clang++ precompiles first, since they take
# half of the time otherwise
file(MAKE_DIRECTORY ${SCRATCH})
set(precompiled)
if(PRECOMPILED)
  list(TRANSFORM PRECOMPILED REPLACE "(.+)" "#include <\\1>\n")
  list(JOIN PRECOMPILED "" text)
  file(WRITE ${SCRATCH}/precompiled.h "${text}")
  execute_process(COMMAND ${CXX} ${FLAGS} -x c++-header ${SCRATCH}/precompiled.h -o ${SCRATCH}/precompiled.pch
                  COMMAND_ERROR_IS_FATAL ANY)
  set(precompiled -include-pch ${SCRATCH}/precompiled.pch)
endif()

set(failed)
function(compile name text)
  file(WRITE ${SCRATCH}/header.cpp "${text}")
  execute_process(COMMAND ${CXX} ${FLAGS} ${precompiled} -fsyntax-only ${SCRATCH}/header.cpp RESULT_VARIABLE result)
  if(result)
    set(failed ${failed} ${name} PARENT_SCOPE)
  endif()
endfunction()

set(all_public)
foreach(header IN LISTS HEADERS)
  compile(${header} "#include <${header}>\n#include <${header}>\n")
  if(NOT header MATCHES "/internal/")
    string(APPEND all_public "#include <${header}>\n")
  endif()
endforeach()
compile("all of them" "${all_public}")
if(failed)
  message(FATAL_ERROR "these do not compile: ${failed}")
endif()
