# The installed package: occlude::kernel, occlude::culler, occlude::c and occlude::c_shared.
include(CMakeFindDependencyMacro)
find_dependency(glm)
find_dependency(Threads)
find_dependency(hwy)  # the libraries are static, so a program that links them must link what they call
include(${CMAKE_CURRENT_LIST_DIR}/occlude-targets.cmake)
