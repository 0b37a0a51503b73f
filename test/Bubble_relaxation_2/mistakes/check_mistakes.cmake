# Compiles a SOURCE with the mistakes of each part: there must be one error for each, with the words above it, and none
# for what is right. CXX: the compiler; FLAGS: with which headers are found
function(count result pattern text)
  string(REGEX MATCHALL "${pattern}" all "${text}")
  list(LENGTH all n)
  set(${result} ${n} PARENT_SCOPE)
endfunction()

file(READ ${SOURCE} source)
string(REGEX REPLACE ";" "" source "${source}")
string(REGEX REPLACE "#(el)?if MISTAKES == " ";" parts "${source}")
list(REMOVE_AT parts 0) # what is right, which is compiled with each part
foreach(part IN LISTS parts)
  string(REGEX MATCH "^[0-9]+" number "${part}")
  string(REGEX MATCHALL "// wrong: [^\n]*" mistakes "${part}")
  execute_process(
    COMMAND ${CXX} -std=c++17 -fsyntax-only -DMISTAKES=${number} ${FLAGS} ${SOURCE}
    ERROR_VARIABLE said)
  list(LENGTH mistakes wanted)
  count(errors "error:" "${said}")
  if(NOT errors EQUAL wanted)
    message(FATAL_ERROR "${errors} errors for ${wanted} mistakes:\n${said}")
  endif()
  foreach(mistake IN LISTS mistakes)
    string(REPLACE "// wrong: " "" words "${mistake}")
    count(errors "error: [^\n]*${words}" "${said}")
    if(NOT errors EQUAL 1)
      message(FATAL_ERROR "${errors} errors with the words '${words}':\n${said}")
    endif()
  endforeach()
endforeach()
