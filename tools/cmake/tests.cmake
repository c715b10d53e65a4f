# One doctest executable a folder of tests/, with what they share (tests/support) as a library.

need_header(doctest/doctest.h doctest-dev doctest)

# Embree, where installed, is the independent oracle; CRSH_EMBREE is its major version.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 QUIET)
endif()

file(GLOB support CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/support/*.cpp)
add_library(test_support STATIC ${support})
target_include_directories(test_support PUBLIC ${PROJECT_SOURCE_DIR}/tests)
target_compile_definitions(test_support PUBLIC
  CRSH_SOURCE_DIR="${PROJECT_SOURCE_DIR}" CRSH_BUILD_DIR="${CMAKE_BINARY_DIR}")
target_link_libraries(test_support PUBLIC crsh_core)
if(embree_FOUND)
  target_compile_definitions(test_support PUBLIC CRSH_EMBREE=${embree_VERSION_MAJOR})
  target_link_libraries(test_support PUBLIC embree)
endif()

foreach(folder unit stages properties images cli robustness viewer)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${folder}/*.cpp)
  if(CRSH_ONLY)
    string(REPLACE ";" "|" owned "gpu;${CRSH_ONLY}")
    list(FILTER sources INCLUDE REGEX "/(${owned})[^/]*\\.cpp$")
  endif()
  if(NOT sources)
    continue()
  endif()
  add_executable(test_${folder} ${sources})
  target_link_libraries(test_${folder} PRIVATE test_support)
  target_compile_options(test_${folder} PRIVATE -O1)  # doctest's macros take twice as long to compile with more
  foreach(program crsh crsh-view)
    if(TARGET ${program} AND folder MATCHES "cli|robustness|images|viewer")
      add_dependencies(test_${folder} ${program})
    endif()
  endforeach()
  add_test(NAME ${folder} COMMAND test_${folder})
endforeach()
