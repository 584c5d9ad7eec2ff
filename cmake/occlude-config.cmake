# The installed package: occlude::kernel, occlude::culler, occlude::c and occlude::c_shared.
include(CMakeFindDependencyMacro)
find_dependency(glm)
find_dependency(Threads)
include(${CMAKE_CURRENT_LIST_DIR}/occlude-targets.cmake)
get_target_property(occlude_type occlude::kernel TYPE)
if(occlude_type STREQUAL "STATIC_LIBRARY")
  find_dependency(hwy)  # a program that links them must link what they call
endif()
