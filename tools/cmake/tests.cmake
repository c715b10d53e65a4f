# One doctest executable a folder of tests/, with what they share (tests/support) as a library.

need_header(doctest/doctest.h doctest-dev doctest)

# Embree, where installed, is the independent oracle; CRSH_EMBREE is its major version.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 QUIET)
endif()

file(GLOB support CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/support/*.cpp)
# The tests' only shader of their own, as a C++ array.
set(arithmetic_shader ${PROJECT_SOURCE_DIR}/tests/support/arithmetic.comp)
set(arithmetic_header ${CMAKE_BINARY_DIR}/generated/tests/arithmetic_probe.h)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/generated/tests)
add_custom_command(OUTPUT ${arithmetic_header}
  COMMAND ${GLSLANG} --quiet --target-env vulkan1.3 --target-env spirv1.5 --vn arithmetic_probe -o ${arithmetic_header}
          ${arithmetic_shader}
  DEPENDS ${arithmetic_shader} COMMENT "Shader arithmetic.comp" VERBATIM)
add_library(test_support STATIC ${support} ${arithmetic_header})
target_include_directories(test_support PUBLIC ${PROJECT_SOURCE_DIR}/tests)
target_include_directories(test_support PRIVATE ${CMAKE_BINARY_DIR}/generated/tests)
target_compile_definitions(test_support PUBLIC
  CRSH_SOURCE_DIR="${PROJECT_SOURCE_DIR}" CRSH_BUILD_DIR="${CMAKE_BINARY_DIR}")
set(engine ${built})
list(FILTER engine EXCLUDE REGEX "^crsh_(bench|cli|gpu_window|viewer.*)$")
target_link_libraries(test_support PUBLIC ${engine} crsh_flags)
if(embree_FOUND)
  target_compile_definitions(test_support PUBLIC CRSH_EMBREE=${embree_VERSION_MAJOR})
  target_link_libraries(test_support PUBLIC embree)
endif()

option(CRSH_TEST_SUBSET "Of tests/, only robustness and the files with tests of the suite \"subset\"" OFF)

# Drops the files without such tests from the list `sources`.
function(keep_subset)
  foreach(source IN LISTS sources)
    file(STRINGS ${source} found REGEX "(test_suite|TEST_SUITE_BEGIN)\\(\"subset\"\\)" LIMIT_COUNT 1)
    if(source MATCHES "_test\\.cpp$" AND NOT found AND NOT source MATCHES "/robustness/")
      list(REMOVE_ITEM sources ${source})
    endif()
  endforeach()
  if(NOT sources MATCHES "_test\\.cpp")
    set(sources)
  endif()
  set(sources ${sources} PARENT_SCOPE)
endfunction()

# Links what a program's files include of the folders that few tests need and that take long to build.
function(link_fronts program)
  foreach(source IN LISTS ARGN)
    foreach(front bench cli viewer)
      file(STRINGS ${source} found REGEX "^#include \"${front}/" LIMIT_COUNT 1)
      if(found)
        target_link_libraries(${program} PRIVATE crsh_${front})
      endif()
    endforeach()
  endforeach()
endfunction()

foreach(folder unit stages properties images oracle cli robustness viewer)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${folder}/*.cpp)
  if(folder STREQUAL oracle AND NOT embree_FOUND)
    message(STATUS "test_oracle is left out: Embree is missing (the Debian package libembree-dev)")
    continue()
  endif()
  if(CRSH_ONLY)
    string(REPLACE ";" "|" owned "gpu;${CRSH_ONLY}")
    list(FILTER sources INCLUDE REGEX "/(${owned})[^/]*\\.cpp$")
  endif()
  if(CRSH_TEST_SUBSET)
    keep_subset()
  endif()
  if(NOT CRSH_VIEWER)  # nothing of it is built
    list(FILTER sources EXCLUDE REGEX "/(viewer/|viewer_)[^/]*\\.cpp$")
  endif()
  if(NOT sources)
    continue()
  endif()
  add_executable(test_${folder} ${sources})
  link_fronts(test_${folder} ${sources})
  target_link_libraries(test_${folder} PRIVATE test_support)
  target_compile_options(test_${folder} PRIVATE -O1)  # doctest's macros take twice as long to compile with more
  foreach(program crsh crsh-view)
    if(TARGET ${program} AND folder MATCHES "cli|robustness|images|viewer")
      add_dependencies(test_${folder} ${program})
    endif()
  endforeach()
  if(TARGET crsh_library AND folder STREQUAL cli)
    add_dependencies(test_cli crsh_library)  # package_test.cpp installs it
  endif()
  foreach(program test_unit test_stages test_properties test_images)  # extension_test.cpp links their objects
    if(TARGET ${program} AND folder STREQUAL cli)
      add_dependencies(test_${folder} ${program})
    endif()
  endforeach()
  add_test(NAME ${folder} COMMAND test_${folder})
endforeach()
