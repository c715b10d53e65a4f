# find_package(crsh): the target crsh::crsh. The folder may be moved: what lies in it is found from where this file is.

include(CMakeFindDependencyMacro)
find_dependency(Vulkan)
find_dependency(fmt)
include(${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake)
set(crsh_needs CRSH_GLM_INCLUDE_DIR)
foreach(decoder IN LISTS crsh_decoders)
  list(APPEND crsh_needs CRSH_LIBRARY_${decoder})
endforeach()
foreach(need IN LISTS crsh_needs)
  if(NOT ${need})
    set(crsh_FOUND FALSE)
    set(crsh_NOT_FOUND_MESSAGE
        "it needs the Debian packages libglm-dev, libpng-dev, libjpeg-dev, libwebp-dev, libavif-dev, libdraco-dev and libmeshoptimizer-dev")
    return()
  endif()
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/crshTargets.cmake)
