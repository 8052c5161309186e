# Installs a build into a folder of its own, and builds and runs a project there that knows nothing else. Run by ctest:
#   cmake -D SOURCE=... -D BUILD=... -D WORK=... -D CONFIG=... -D GENERATOR=... -D COMPILER=... -D SANITIZE=...
#         -P check_package.cmake

file(REMOVE_RECURSE ${WORK})
set(ENV{DESTDIR} "")  # nothing may land outside WORK, whatever the caller's environment

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN} failed (${status}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${WORK}/prefix)
foreach(file IN ITEMS share/man/man1/gridstep.1 share/bash-completion/completions/gridstep)
  if(NOT EXISTS ${WORK}/prefix/${file})
    message(FATAL_ERROR "${file} was not installed")
  endif()
endforeach()
file(GLOB_RECURSE strays ${WORK}/prefix/*_test.* ${WORK}/prefix/*testing_* ${WORK}/prefix/include/*.cpp)
if(strays)
  message(FATAL_ERROR "installed, but only of use to tests: ${strays}")
endif()
file(GLOB_RECURSE exports ${WORK}/prefix/*/gridstep-targets*.cmake)
foreach(export IN LISTS exports)
  file(READ ${export} text)
  foreach(leak gridstep_warnings -Wall ${SOURCE}/ ${BUILD}/)
    string(FIND "${text}" "${leak}" position)
    # The prefix of this test is in the build folder, and is not written into the export.
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${export} passes ${leak} on to those who use the library")
    endif()
  endforeach()
endforeach()

set(flags)
if(SANITIZE)
  set(flags -D CMAKE_CXX_FLAGS=-fsanitize=${SANITIZE})
endif()
run(${CMAKE_COMMAND} -S ${SOURCE}/scripts/consumer -B ${WORK}/build -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_PREFIX_PATH=${WORK}/prefix ${flags})
run(${CMAKE_COMMAND} --build ${WORK}/build --config ${CONFIG})
file(GLOB_RECURSE consumer ${WORK}/build/consumer ${WORK}/build/*/consumer)
list(GET consumer 0 consumer)
run(${consumer})
message("${output}")
file(REMOVE_RECURSE ${WORK})
