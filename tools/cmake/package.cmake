# What `find_package(crsh)` finds: the target crsh::crsh, made of all floors up to frame, and the headers of src/crsh/.
#
# A static library, of the very objects that crsh and the tests are made of: what is tested is what is installed,
# nothing is compiled twice, and no binary interface is promised before 1.0. To link it into a shared library, build
# with -DCMAKE_POSITION_INDEPENDENT_CODE=ON. To install nothing else: cmake --install build --component library.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(package/dependencies)  # as the installed package does

set(library_objects $<TARGET_OBJECTS:crsh_shaders>)
foreach(folder IN LISTS floors)
  string(REPLACE "/" "_" name crsh_${folder})
  if(TARGET ${name})
    list(APPEND library_objects $<TARGET_OBJECTS:${name}>)
  endif()
  if(folder STREQUAL frame)
    break()
  endif()
endforeach()
add_library(crsh_library STATIC ${library_objects})
set_target_properties(crsh_library PROPERTIES OUTPUT_NAME crsh EXPORT_NAME crsh LINKER_LANGUAGE CXX)
target_compile_features(crsh_library INTERFACE cxx_std_20)
list(TRANSFORM crsh_decoders PREPEND crsh:: OUTPUT_VARIABLE decoders)
target_link_libraries(crsh_library PUBLIC crsh::glm PRIVATE Vulkan::Vulkan fmt::fmt ${decoders})

# Every header of src/crsh/ that holds no internals, and those of shaders/shared/, which they include, in crsh/shared/:
# an include folder of others has no room for a "shared".
set(header_output ${CMAKE_BINARY_DIR}/include/crsh)
file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/src/crsh ${PROJECT_SOURCE_DIR}/src/crsh/*.h)
list(REMOVE_ITEM headers assertion.h leaks.h)
list(TRANSFORM headers PREPEND ${PROJECT_SOURCE_DIR}/src/crsh/)
file(GLOB shared_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/shared/*.h)

# Copies these files to `folder`, with their includes as the installed ones have them, and installs them.
function(install_headers folder)
  foreach(header IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
    file(READ ${header} text)
    string(REPLACE "#include \"shared/" "#include \"crsh/shared/" text "${text}")
    get_filename_component(file ${header} NAME)
    file(WRITE ${header_output}${folder}/${file} "${text}")
    install(FILES ${header_output}${folder}/${file} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/crsh${folder}
            COMPONENT library)
  endforeach()
endfunction()
install_headers("" ${headers})
install_headers("/shared" ${shared_headers})

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/crsh)
install(TARGETS crsh_library EXPORT crshTargets COMPONENT library
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT crshTargets NAMESPACE crsh:: DESTINATION ${package_folder} COMPONENT library)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/generated/crshConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/generated/crshConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/package/crshConfig.cmake
              ${CMAKE_CURRENT_LIST_DIR}/package/dependencies.cmake
        DESTINATION ${package_folder} COMPONENT library)
