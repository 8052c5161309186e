# Builds report.html, the page without data, and writes it as a C++ raw string for experiments/report/page_template.cpp:
#   cmake -D SOURCE=scripts/report -D WORK=... -D NODE=... -D NPM=... -D INCLUDE=... -D RETRY=... -P build_page.cmake
# Works on a copy: builds side by side do not get into each other's way, and the sources stay as they are. Without
# NODE, or where npm fails, the string is empty, and the program goes without the page.

set(page "")
if(NODE)
  file(COPY ${SOURCE}/ DESTINATION ${WORK} PATTERN node_modules EXCLUDE)
  foreach(step "ci;--prefer-offline;--fetch-retries=1;--fetch-retry-mintimeout=1000" "run;build;--silent")
    execute_process(COMMAND ${CMAKE_COMMAND} -E env "PATH=${NODE}:$ENV{PATH}" ${NPM} ${step} WORKING_DIRECTORY ${WORK}
                    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT status EQUAL 0)
      list(GET step 0 command)
      message(WARNING "npm ${command} failed: this gridstep will not write report.html. The next build tries again.\n"
                      "${output}")
      break()
    endif()
  endforeach()
  if(status EQUAL 0)
    file(READ ${WORK}/dist/report.html page)
  endif()
endif()
file(WRITE ${INCLUDE} "R\"gridstep_page(${page})gridstep_page\"\n")
if(NODE AND NOT page)
  file(TOUCH ${RETRY})
endif()
