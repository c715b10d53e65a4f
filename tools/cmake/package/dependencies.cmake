# What the library needs that has no CMake files in every release of Debian, as targets. Read by the build and by
# find_package(crsh).

if(NOT TARGET crsh::glm)
  find_path(CRSH_GLM_INCLUDE_DIR glm/glm.hpp)
  find_library(CRSH_STB_LIBRARY stb)
  mark_as_advanced(CRSH_GLM_INCLUDE_DIR CRSH_STB_LIBRARY)
  add_library(crsh::glm INTERFACE IMPORTED)
  set_target_properties(crsh::glm PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${CRSH_GLM_INCLUDE_DIR}")
  add_library(crsh::stb UNKNOWN IMPORTED)
  set_target_properties(crsh::stb PROPERTIES IMPORTED_LOCATION "${CRSH_STB_LIBRARY}")
endif()
