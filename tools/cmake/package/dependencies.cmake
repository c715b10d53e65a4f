# What the library needs that has no CMake files in every release of Debian, as targets. Read by the build and by
# find_package(crsh).

# What reads pictures.
set(crsh_decoders png jpeg webp avif draco meshoptimizer)

if(NOT TARGET crsh::glm)
  find_path(CRSH_GLM_INCLUDE_DIR glm/glm.hpp)
  mark_as_advanced(CRSH_GLM_INCLUDE_DIR)
  add_library(crsh::glm INTERFACE IMPORTED)
  set_target_properties(crsh::glm PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${CRSH_GLM_INCLUDE_DIR}")
  foreach(decoder IN LISTS crsh_decoders)
    find_library(CRSH_LIBRARY_${decoder} ${decoder})
    mark_as_advanced(CRSH_LIBRARY_${decoder})
    add_library(crsh::${decoder} UNKNOWN IMPORTED)
    set_target_properties(crsh::${decoder} PROPERTIES IMPORTED_LOCATION "${CRSH_LIBRARY_${decoder}}")
  endforeach()
endif()
