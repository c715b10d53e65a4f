# find_package(crsh): the target crsh::crsh. The folder may be moved: what lies in it is found from where this file is.

include(CMakeFindDependencyMacro)
find_dependency(Vulkan)
find_dependency(fmt)
include(${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake)
if(NOT CRSH_GLM_INCLUDE_DIR OR NOT CRSH_STB_LIBRARY)
  set(crsh_FOUND FALSE)
  set(crsh_NOT_FOUND_MESSAGE "it needs the Debian packages libglm-dev and libstb-dev")
  return()
endif()
include(${CMAKE_CURRENT_LIST_DIR}/crshTargets.cmake)
