# crsh_shaders: every shaders/**/*.comp, .vert and .frag as SPIR-V inside a library, with a table of their names
# (gpu/embedded.h). A shader with a line "// variants: FOLDER" is compiled once for every FOLDER/NAME.glsl, as
# "path@NAME.comp": its #include "variant.glsl" then includes that file. A shader that includes lib/shuffle_read.glsl is
# compiled a second time with CRSH_NO_SHUFFLE defined, as "path-no-shuffle.comp" or "path-no-shuffle@NAME.comp".

set(shader_root ${PROJECT_SOURCE_DIR}/shaders)
set(shader_output ${CMAKE_BINARY_DIR}/shaders)
# SPIR-V 1.5: from 1.6 on glslang writes LocalSizeId, which only devices with maintenance4 enabled accept.
set(shader_flags --quiet --target-env vulkan1.3 --target-env spirv1.5 -I${shader_root})
set(shader_names "")
set(shader_files "")

# Compiles `source` (a path below shaders/) to the embedded file `name`; further arguments are flags.
macro(add_shader source name)
  set(spirv ${shader_output}/${name}.spv)
  get_filename_component(spirv_folder ${spirv} DIRECTORY)
  file(MAKE_DIRECTORY ${spirv_folder})
  add_custom_command(OUTPUT ${spirv}
    COMMAND ${GLSLANG} ${shader_flags} ${ARGN} --depfile ${spirv}.d -o ${spirv} ${shader_root}/${source}
    DEPENDS ${shader_root}/${source} DEPFILE ${spirv}.d COMMENT "Shader ${name}" VERBATIM)
  list(APPEND shader_names ${name})
  list(APPEND shader_files ${spirv})
endmacro()

macro(add_shader_variants source folder)
  file(GLOB variants CONFIGURE_DEPENDS ${shader_root}/${folder}/*.glsl)
  foreach(variant IN LISTS variants)
    get_filename_component(variant_name ${variant} NAME_WE)
    set(variant_folder ${shader_output}/variants/${folder}/${variant_name})
    file(CONFIGURE OUTPUT ${variant_folder}/variant.glsl CONTENT "#include \"${folder}/${variant_name}.glsl\"\n" @ONLY)
    string(REGEX REPLACE "(\\.[a-z]+)$" "@${variant_name}\\1" variant_source ${source})
    add_shader(${source} ${variant_source} -I${variant_folder})
    if(comes_twice)
      string(REPLACE "@" "-no-shuffle@" no_shuffle_source ${variant_source})
      add_shader(${source} ${no_shuffle_source} -I${variant_folder} -DCRSH_NO_SHUFFLE)
    endif()
  endforeach()
endmacro()

file(GLOB_RECURSE shader_sources CONFIGURE_DEPENDS RELATIVE ${shader_root}
     ${shader_root}/*.comp ${shader_root}/*.vert ${shader_root}/*.frag)
list(SORT shader_sources)
foreach(source IN LISTS shader_sources)
  string(REGEX MATCH "^[^/]+" folder ${source})
  if(CRSH_ONLY AND NOT folder IN_LIST CRSH_ONLY)
    continue()
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${shader_root}/${source})  # its variants line
  file(STRINGS ${shader_root}/${source} variants_line REGEX "^// variants: " LIMIT_COUNT 1)
  file(STRINGS ${shader_root}/${source} comes_twice REGEX "^#include \"lib/shuffle_read.glsl\"" LIMIT_COUNT 1)
  if(variants_line)
    string(REGEX REPLACE "^// variants: *([^ ]+).*" "\\1" folder "${variants_line}")
    add_shader_variants(${source} ${folder})
  else()
    add_shader(${source} ${source})
    if(comes_twice)
      string(REGEX REPLACE "(\\.[a-z]+)$" "-no-shuffle\\1" no_shuffle_source ${source})
      add_shader(${source} ${no_shuffle_source} -DCRSH_NO_SHUFFLE)
    endif()
  endif()
endforeach()

# One assembler file includes them all: that takes milliseconds however many there are.
set(assembly ".section .rodata\n")
set(entries "")
set(index 0)
foreach(name file IN ZIP_LISTS shader_names shader_files)
  string(APPEND assembly ".balign 4\n.globl crsh_shader_${index}\n.globl crsh_shader_${index}_end\n"
         "crsh_shader_${index}: .incbin \"${file}\"\ncrsh_shader_${index}_end:\n")
  string(APPEND declarations "extern const uint32_t crsh_shader_${index}[], crsh_shader_${index}_end[];\n")
  string(APPEND entries "    {\"${name}\", crsh_shader_${index}, crsh_shader_${index}_end},\n")
  math(EXPR index "${index} + 1")
endforeach()
string(APPEND assembly ".section .note.GNU-stack,\"\",%progbits\n")
set(shader_assembly ${CMAKE_BINARY_DIR}/generated/shaders.s)
set(shader_table ${CMAKE_BINARY_DIR}/generated/shader_table.cpp)
file(CONFIGURE OUTPUT ${shader_assembly} CONTENT "${assembly}" @ONLY)
file(CONFIGURE OUTPUT ${shader_table} @ONLY CONTENT "// Made by tools/cmake/shaders.cmake.
#include \"gpu/embedded.h\"

extern \"C\" {
${declarations}}

namespace crsh::gpu {

// An empty name ends the table.
extern const EmbeddedFile embedded_table[] = {
${entries}    {{}, nullptr, nullptr}};

}  // namespace crsh::gpu
")
set_source_files_properties(${shader_assembly} PROPERTIES OBJECT_DEPENDS "${shader_files}")
add_library(crsh_shaders STATIC ${shader_assembly} ${shader_table})
target_include_directories(crsh_shaders PRIVATE ${PROJECT_SOURCE_DIR}/src)
