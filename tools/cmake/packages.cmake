# Every package that the build needs, as one target, crsh_packages; what crsh-view needs besides, crsh_window_packages. Those without CMake files in every release of
# Debian are looked for by a header.

add_library(crsh_packages INTERFACE)
add_library(crsh_window_packages INTERFACE)
set(packages crsh_packages)  # whom the next packages are for

# Further arguments: folders below the usual ones.
function(need_header header debian)
  find_path(INCLUDE_${header} ${header} PATH_SUFFIXES ${ARGN})
  mark_as_advanced(INCLUDE_${header})
  if(NOT INCLUDE_${header})
    message(FATAL_ERROR "${header} is missing: install the Debian package ${debian}")
  endif()
  target_include_directories(${packages} SYSTEM INTERFACE ${INCLUDE_${header}})
endfunction()

function(need_library library debian)
  find_library(LIBRARY_${library} ${library})
  mark_as_advanced(LIBRARY_${library})
  if(NOT LIBRARY_${library})
    message(FATAL_ERROR "lib${library} is missing: install the Debian package ${debian}")
  endif()
  target_link_libraries(${packages} INTERFACE ${LIBRARY_${library}})
endfunction()

# `target` is what the package's own CMake file defines.
macro(need_package package target debian)
  set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)  # Debian's Imath tells of a Python binding that is not installed
  find_package(${package} QUIET)
  unset(CMAKE_MESSAGE_LOG_LEVEL)
  if(NOT TARGET ${target})
    message(FATAL_ERROR "${package} is missing: install the Debian package ${debian}")
  endif()
  target_link_libraries(${packages} INTERFACE ${target})
endmacro()

find_program(GLSLANG NAMES glslangValidator glslang)
if(NOT GLSLANG)
  message(FATAL_ERROR "glslangValidator is missing: install the Debian package glslang-tools")
endif()

need_package(Vulkan Vulkan::Vulkan libvulkan-dev)
need_package(OpenEXR OpenEXR::OpenEXR libopenexr-dev)
need_package(fmt fmt::fmt libfmt-dev)
need_header(spirv/unified1/spirv.h spirv-headers)
need_header(glm/glm.hpp libglm-dev)
need_header(CLI/CLI.hpp libcli11-dev)
need_header(nlohmann/json.hpp nlohmann-json3-dev)
need_header(tiny_gltf.h libtinygltf-dev)
need_header(stb_image_write.h libstb-dev stb)
need_header(zip.h libzip-dev)
need_header(png.h libpng-dev)
need_header(jpeglib.h libjpeg-dev)
need_header(webp/decode.h libwebp-dev)
need_header(avif/avif.h libavif-dev)
need_header(draco/compression/decode.h libdraco-dev)
need_header(meshoptimizer.h libmeshoptimizer-dev)
need_library(stb libstb-dev)
need_library(zip libzip-dev)
need_library(png libpng-dev)
need_library(jpeg libjpeg-dev)
need_library(webp libwebp-dev)
need_library(avif libavif-dev)
need_library(draco libdraco-dev)
need_library(meshoptimizer libmeshoptimizer-dev)
target_link_libraries(crsh_packages INTERFACE ${CMAKE_DL_LIBS})
target_compile_definitions(crsh_packages INTERFACE GLM_ENABLE_EXPERIMENTAL)
# Of tinygltf only the header is used, everywhere in this one form: it opens no file and decodes no image.
target_compile_definitions(crsh_packages INTERFACE TINYGLTF_NO_FS TINYGLTF_NO_STB_IMAGE TINYGLTF_NO_STB_IMAGE_WRITE
                           TINYGLTF_NO_INCLUDE_JSON)

if(CRSH_VIEWER)
  # Debian's libimgui is static, holds the GLFW and Vulkan backends, and takes two packers from libstb.
  set(packages crsh_window_packages)
  need_package(glfw3 glfw libglfw3-dev)
  need_header(imgui.h libimgui-dev imgui)
  need_header(imgui_impl_vulkan.h libimgui-dev imgui/backends)
  need_library(imgui libimgui-dev)
  target_link_libraries(crsh_window_packages INTERFACE ${LIBRARY_stb})
  set(packages crsh_packages)
endif()
