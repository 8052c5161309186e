# Writes the header that tells the program which commit it was built from. Runs at every build, and touches the header
# only if something changed:
#   cmake -D SOURCE=... -D HEADER=... -D VERSION=... -D TYPE=... -D FLAGS=... -P write_build_info.cmake

function(git variable)
  execute_process(COMMAND git -C ${SOURCE} ${ARGN} OUTPUT_VARIABLE output RESULT_VARIABLE status
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT status EQUAL 0)
    set(output "unknown")
  endif()
  set(${variable} "${output}" PARENT_SCOPE)
endfunction()

# A copy of the sources inside another project's repository must not take that project's commit for its own.
git(top rev-parse --show-toplevel)
file(REAL_PATH ${SOURCE} source)
set(commit "unknown")
set(dirty "false")
if(top STREQUAL source)
  git(commit rev-parse HEAD)
  git(changes status --porcelain -- CMakeLists.txt shapes estimators experiments scripts/report)
  if(changes)
    set(dirty "true")
  endif()
endif()

string(REPLACE ";" " " flags "${FLAGS}")
string(REGEX REPLACE " +" " " flags "${flags}")
string(STRIP "${flags}" flags)
string(REGEX REPLACE "([\\\"])" "\\\\\\1" flags "${flags}")
set(content "#define GRIDSTEP_VERSION \"${VERSION}\"
#define GRIDSTEP_COMMIT \"${commit}\"
#define GRIDSTEP_DIRTY ${dirty}
#define GRIDSTEP_BUILD_TYPE \"${TYPE}\"
#define GRIDSTEP_FLAGS \"${flags}\"
")
set(before "")
if(EXISTS ${HEADER})
  file(READ ${HEADER} before)
endif()
if(NOT content STREQUAL before)
  file(WRITE ${HEADER} "${content}")
endif()
