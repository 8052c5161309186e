# Finds what the headers of Gridstep include and its library links; defines gridstep::gridstep.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.3 NO_MODULE)
find_dependency(Boost 1.74)
find_dependency(fmt)
find_dependency(nlohmann_json 3.9)
find_dependency(TBB)
find_dependency(ZLIB)
include(${CMAKE_CURRENT_LIST_DIR}/gridstep-targets.cmake)
