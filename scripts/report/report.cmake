# The page report.html, made with Node and npm where they are found and put into the program. Defines
# GRIDSTEP_REPORT, whether it is there.

find_program(GRIDSTEP_NODE NAMES node nodejs DOC "Node 18 or newer, for report.html")
find_program(GRIDSTEP_NPM NAMES npm DOC "npm, for report.html")
set(GRIDSTEP_REPORT FALSE)
if(GRIDSTEP_NODE AND GRIDSTEP_NPM)
  execute_process(COMMAND ${GRIDSTEP_NODE} --version OUTPUT_VARIABLE node_version OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REGEX REPLACE "^v" "" node_version "${node_version}")
  if(node_version VERSION_GREATER_EQUAL 18)
    set(GRIDSTEP_REPORT TRUE)
  endif()
endif()

set(report_source ${PROJECT_SOURCE_DIR}/scripts/report)
set(report_include ${PROJECT_BINARY_DIR}/generated/gridstep_report_page.inc)
set(report_retry ${PROJECT_BINARY_DIR}/generated/retry_report_page)  # touched by a failure: newer than the page
set(report_node)
if(GRIDSTEP_REPORT)
  cmake_path(GET GRIDSTEP_NODE PARENT_PATH report_node)
  if(NOT EXISTS ${report_retry})
    file(WRITE ${report_retry} "")
  endif()
else()
  message(STATUS "Node 18 and npm were not found: gridstep will not write report.html")
endif()
file(GLOB report_sources CONFIGURE_DEPENDS ${report_source}/*.* ${report_source}/src/*.*
     ${report_source}/test/*.*)
add_custom_command(
  OUTPUT ${report_include}
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${report_source} -D WORK=${PROJECT_BINARY_DIR}/report -D "NODE=${report_node}"
          -D "NPM=${GRIDSTEP_NPM}" -D INCLUDE=${report_include} -D RETRY=${report_retry}
          -P ${report_source}/build_page.cmake
  DEPENDS ${report_sources} $<$<BOOL:${GRIDSTEP_REPORT}>:${report_retry}>
  COMMENT "Building the report page" VERBATIM)
set_source_files_properties(experiments/report/page_template.cpp PROPERTIES
                            INCLUDE_DIRECTORIES ${PROJECT_BINARY_DIR}/generated OBJECT_DEPENDS ${report_include})
