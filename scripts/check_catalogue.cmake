# A catalogue line without its file has to stop the configuration, with a message that says which. Run by ctest:
#   cmake -D SOURCE=... -D WORK=... -D GENERATOR=... -D COMPILER=... -P check_catalogue.cmake

foreach(catalogue shapes/analytic/catalogue.inc estimators/catalogue.inc experiments/catalogue.inc)
  file(REMOVE_RECURSE ${WORK})
  foreach(entry CMakeLists.txt shapes estimators experiments bench scripts)
    if(EXISTS ${SOURCE}/${entry})
      file(COPY ${SOURCE}/${entry} DESTINATION ${WORK}/source)
    endif()
  endforeach()
  # A line of the same kind as those that are there.
  file(STRINGS ${SOURCE}/${catalogue} lines REGEX "^GRIDSTEP_[A-Z]+\\(")
  list(GET lines 0 line)
  string(REGEX REPLACE "\\(.*" "(no_such_file)" line "${line}")
  file(APPEND ${WORK}/source/${catalogue} "${line}\n")

  execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/source -B ${WORK}/build -G ${GENERATOR}
                          -D CMAKE_CXX_COMPILER=${COMPILER} -D GRIDSTEP_TESTS=OFF -D GRIDSTEP_BENCHMARKS=OFF
                  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " flat "${output}")  # CMake wraps long messages
  cmake_path(GET catalogue PARENT_PATH folder)
  set(expected "${catalogue} lists 'no_such_file', but ${folder} has no no_such_file.cpp")
  string(FIND "${flat}" "${expected}" position)
  if(status EQUAL 0 OR position EQUAL -1)
    message(FATAL_ERROR "expected a failure that says: ${expected}\ngot status ${status} and:\n${output}")
  endif()
  message("${catalogue}: refused, as it should be")
endforeach()
file(REMOVE_RECURSE ${WORK})
