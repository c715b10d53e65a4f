# ${version_file} holds src/crsh/version.h's constants; the target look_up_commit writes it. The commit is looked up at every build, and compiled only when it changed.
# Run as a script (-P) this file is that look-up.

if(CMAKE_SCRIPT_MODE_FILE)
  set(COMMIT unknown)
  if(EXISTS ${SOURCE}/.git)
    execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 --verify HEAD OUTPUT_VARIABLE hash RESULT_VARIABLE failed
                    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT failed)
      set(COMMIT ${hash})
    endif()
  endif()
  configure_file(${SOURCE}/src/crsh/version.cpp.in ${TARGET} @ONLY)  # writes only what differs
  return()
endif()

set(version_file ${CMAKE_BINARY_DIR}/generated/version.cpp)
add_custom_target(look_up_commit BYPRODUCTS ${version_file}
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DTARGET=${version_file} -DVERSION=${PROJECT_VERSION}
          -P ${CMAKE_CURRENT_LIST_FILE}
  COMMENT "" VERBATIM)
