// The small part of SPIR-V reflection that dispatches need: the two sets, the push block's size, the workgroup's size.

#include <spirv/unified1/spirv.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "crsh/assertion.h"
#include "gpu/embedded.h"
#include "gpu/reflection.h"

namespace crsh::gpu {
namespace {

/// Thrown for a shader that this reflection cannot read; for an embedded one that is an error of the programmer.
struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void require(bool condition, const std::string& why) {
  if (!condition) throw Unreadable(why);
}

constexpr size_t header_words = 5;
constexpr uint32_t max_push_bytes = 128;  // what every device allows

/// One type, constant or variable: its opcode and operands (words behind the opcode, the result id left in).
struct Definition {
  SpvOp op = SpvOpNop;
  std::span<const uint32_t> operands;
};

struct MemberLayout {
  uint32_t offset = 0, matrix_stride = 0;
};

/// A parsed module: definitions, names and decorations by id.
struct Module {
  std::map<uint32_t, Definition> definitions;
  std::vector<uint32_t> variables;
  std::map<uint32_t, std::string> names, last_member_names;
  std::map<uint32_t, uint32_t> binding, set, array_stride, spec_id, location;
  std::map<uint32_t, bool> buffer_block;
  std::map<uint32_t, std::vector<MemberLayout>> members;
  std::array<uint32_t, 3> local_size = {1, 1, 1};
  uint32_t workgroup_size = 0;  ///< id of the constant that replaces local_size, if any
  bool tells_lanes_apart = false, is_fragment = false;

  [[nodiscard]] const Definition& at(uint32_t id) const { return definitions.at(id); }
};

void decorate(Module& module, std::span<const uint32_t> operands) {
  const uint32_t id = operands[0];
  switch (operands[1]) {
    case SpvDecorationBinding: module.binding[id] = operands[2]; break;
    case SpvDecorationDescriptorSet: module.set[id] = operands[2]; break;
    case SpvDecorationArrayStride: module.array_stride[id] = operands[2]; break;
    case SpvDecorationSpecId: module.spec_id[id] = operands[2]; break;
    case SpvDecorationLocation: module.location[id] = operands[2]; break;
    case SpvDecorationBufferBlock: module.buffer_block[id] = true; break;
    case SpvDecorationBuiltIn:
      if (operands[2] == SpvBuiltInWorkgroupSize) module.workgroup_size = id;
      if (operands[2] == SpvBuiltInSubgroupId || operands[2] == SpvBuiltInSubgroupLocalInvocationId)
        module.tells_lanes_apart = true;
      break;
    default: break;
  }
}

void decorate_member(Module& module, std::span<const uint32_t> operands) {
  std::vector<MemberLayout>& members = module.members[operands[0]];
  members.resize(std::max<size_t>(members.size(), operands[1] + 1));
  if (operands[2] == SpvDecorationOffset) members[operands[1]].offset = operands[3];
  if (operands[2] == SpvDecorationMatrixStride) members[operands[1]].matrix_stride = operands[3];
}

/// Where an instruction that makes a definition has its result id among its operands.
size_t result_place(SpvOp op) {
  // clang-format off
  switch (op) {
    case SpvOpTypeInt: case SpvOpTypeFloat: case SpvOpTypeBool: case SpvOpTypeVector: case SpvOpTypeMatrix:
    case SpvOpTypeArray: case SpvOpTypeRuntimeArray: case SpvOpTypeStruct: case SpvOpTypePointer: case SpvOpTypeImage:
    case SpvOpTypeSampledImage: case SpvOpTypeAccelerationStructureKHR:
      return 0;
    case SpvOpConstant: case SpvOpSpecConstant: case SpvOpConstantComposite: case SpvOpSpecConstantComposite:
    case SpvOpVariable:
      return 1;
    default: return SIZE_MAX;
  }
  // clang-format on
}

/// A string literal: bytes in words, ended by a zero.
std::string text_of(std::span<const uint32_t> words) {
  const char* bytes = reinterpret_cast<const char*>(words.data());
  return {bytes, strnlen(bytes, words.size_bytes())};
}

void take_name(Module& module, SpvOp op, std::span<const uint32_t> operands) {
  if (op == SpvOpName) module.names[operands[0]] = text_of(operands.subspan(1));
  if (op == SpvOpMemberName)
    module.last_member_names[operands[0]] = text_of(operands.subspan(2));  // they come in order
}

void take(Module& module, SpvOp op, std::span<const uint32_t> operands) {
  take_name(module, op, operands);
  if (op == SpvOpEntryPoint) module.is_fragment = operands[0] == SpvExecutionModelFragment;
  if (op == SpvOpDecorate) decorate(module, operands);
  if (op == SpvOpMemberDecorate) decorate_member(module, operands);
  if (op == SpvOpExecutionMode && operands[1] == SpvExecutionModeLocalSize)
    std::copy_n(operands.begin() + 2, 3, module.local_size.begin());
  require(op != SpvOpExecutionModeId, "LocalSizeId needs maintenance4: compile for SPIR-V 1.5");
  const size_t place = result_place(op);
  if (place == SIZE_MAX) return;
  module.definitions[operands[place]] = {op, operands};
  if (op == SpvOpVariable) module.variables.push_back(operands[1]);
}

Module parse(std::span<const uint32_t> spirv) {
  require(spirv.size() > header_words && spirv[0] == SpvMagicNumber, "that is no SPIR-V");
  Module module;
  for (size_t at = header_words; at < spirv.size();) {
    const size_t words = spirv[at] >> SpvWordCountShift;
    require(words > 0 && at + words <= spirv.size(), "broken SPIR-V");
    const auto op = static_cast<SpvOp>(spirv[at] & SpvOpCodeMask);
    if (op == SpvOpFunction) break;  // all definitions come before
    take(module, op, spirv.subspan(at + 1, words - 1));
    at += words;
  }
  return module;
}

uint32_t constant(const Module& module, uint32_t id) {
  const Definition& definition = module.at(id);
  require(definition.op == SpvOpConstant || definition.op == SpvOpSpecConstant, "not a scalar constant");
  return definition.operands[2];
}

uint32_t size_of(const Module& module, uint32_t type, const MemberLayout& layout);

uint32_t struct_size(const Module& module, uint32_t type) {
  const auto members = module.at(type).operands.subspan(1);
  uint32_t end = 0;
  for (size_t i = 0; i < members.size(); ++i) {
    const MemberLayout& layout = module.members.at(type)[i];
    end = std::max(end, layout.offset + size_of(module, members[i], layout));
  }
  return end;
}

/// Bytes of a type inside a block; `layout` is that of the member, for matrices.
uint32_t size_of(const Module& module, uint32_t type, const MemberLayout& layout) {
  const Definition& definition = module.at(type);
  const auto operands = definition.operands;
  switch (definition.op) {
    case SpvOpTypeInt:
    case SpvOpTypeFloat: return operands[1] / 8;
    case SpvOpTypeVector: return operands[2] * size_of(module, operands[1], layout);
    case SpvOpTypeMatrix: return operands[2] * layout.matrix_stride;
    case SpvOpTypeArray: return constant(module, operands[2]) * module.array_stride.at(type);
    case SpvOpTypeStruct: return struct_size(module, type);
    default: require(false, "a push constant of an unexpected type"); return 0;
  }
}

Resource image_kind(const Definition& type) {
  constexpr uint32_t sampled = 1, storage = 2;
  require(type.op == SpvOpTypeImage, "samplers are not supported: read a textureBuffer by texelFetch()");
  const bool is_buffer = type.operands[2] == SpvDimBuffer;
  if (is_buffer && type.operands[6] == sampled) return Resource::texel_buffer;
  require(!is_buffer && type.operands[6] == storage, "of images, only single storage images are supported");
  return Resource::storage_image;
}

/// The kind of resource a variable is, or none for inputs, outputs and the like.
std::optional<Resource> resource_of(const Module& module, SpvStorageClass storage, uint32_t pointee) {
  if (storage == SpvStorageClassStorageBuffer) return Resource::storage_buffer;
  if (storage == SpvStorageClassUniform) {
    require(module.buffer_block.contains(pointee),
            "uniform buffers are not supported: use a push constant or a buffer");
    return Resource::storage_buffer;
  }
  if (storage != SpvStorageClassUniformConstant) return std::nullopt;
  const Definition& type = module.at(pointee);
  return type.op == SpvOpTypeAccelerationStructureKHR ? Resource::acceleration_structure : image_kind(type);
}

std::string name_of(const Module& module, uint32_t variable, Resource kind, uint32_t pointee) {
  const auto& names = kind == Resource::storage_buffer ? module.last_member_names : module.names;
  const auto found = names.find(kind == Resource::storage_buffer ? pointee : variable);
  require(found != names.end() && !found->second.empty(), "it lacks its names: compile without -g0");
  return found->second;
}

/// What modules declare together, bindings with gaps included.
struct Interface {
  bool operator==(const Interface&) const = default;
  std::map<uint32_t, Declared> arguments, tables;  ///< by binding
  uint32_t push_bytes = 0;
};

void add_variable(const Module& module, uint32_t id, Interface& all) {
  const auto operands = module.at(id).operands;  // pointer type, id, storage class
  const auto storage = static_cast<SpvStorageClass>(operands[2]);
  const uint32_t pointee = module.at(operands[0]).operands[2];
  if (storage == SpvStorageClassPushConstant) all.push_bytes = std::max(all.push_bytes, struct_size(module, pointee));
  const std::optional<Resource> kind = resource_of(module, storage, pointee);
  if (!kind) return;
  const uint32_t set = module.set.at(id);
  require(set <= table_set, "only descriptor sets 0 and 1 are supported");
  const Declared declared{name_of(module, id, *kind, pointee), *kind};
  const auto [known, added] =
      (set == table_set ? all.tables : all.arguments).try_emplace(module.binding.at(id), declared);
  require(known->second.kind == *kind, "one binding is two kinds of resource");
  require(known->second == declared, "one binding has two names, " + known->second.name + " and " + declared.name);
}

void set_local_size(const Module& module, Reflection& reflection) {
  std::copy_n(module.local_size.begin(), 3, reflection.local_size);
  if (!module.workgroup_size) return;
  const auto parts = module.at(module.workgroup_size).operands.subspan(2);  // behind the type and the id
  for (size_t i = 0; i < 3; ++i) {
    reflection.local_size[i] = constant(module, parts[i]);
    const auto id = module.spec_id.find(parts[i]);
    if (id != module.spec_id.end()) reflection.local_size_id[i] = id->second;
  }
}

uint32_t count_colours(const Module& module) {
  return static_cast<uint32_t>(std::ranges::count_if(module.variables, [&](uint32_t id) {
    return module.is_fragment && module.at(id).operands[2] == SpvStorageClassOutput && module.location.contains(id);
  }));
}

/// By binding; asserts that bindings count up and that names tell them apart.
std::vector<Declared> in_order(const std::map<uint32_t, Declared>& bindings, const std::string& set) {
  std::vector<Declared> all;
  std::set<std::string> names;
  for (const auto& [binding, declared] : bindings) {
    require(binding == all.size(), "bindings of set " + set + " must count from 0 without gaps");
    require(names.insert(declared.name).second, "two bindings are called " + declared.name);
    all.push_back(declared);
  }
  return all;
}

Reflection reflect_all(std::span<const std::span<const uint32_t>> modules) {
  Reflection reflection;
  Interface all;
  for (const std::span<const uint32_t>& spirv : modules) {
    const Module module = parse(spirv);
    for (const uint32_t id : module.variables) add_variable(module, id, all);
    set_local_size(module, reflection);
    reflection.tells_lanes_apart |= module.tells_lanes_apart;
    reflection.colour_attachments += count_colours(module);
  }
  reflection.arguments = in_order(all.arguments, "0");
  reflection.tables = in_order(all.tables, "1");
  reflection.push_bytes = all.push_bytes;
  require(reflection.push_bytes <= max_push_bytes, "a push block of more than 128 bytes");
  return reflection;
}

Interface interface_of(std::span<const uint32_t> spirv) {
  const Module module = parse(spirv);
  Interface all;
  for (const uint32_t id : module.variables) add_variable(module, id, all);
  return all;
}

/// With the names taken off.
std::vector<std::pair<uint32_t, Resource>> kinds_of(const std::map<uint32_t, Declared>& bindings) {
  std::vector<std::pair<uint32_t, Resource>> kinds;
  for (const auto& [binding, declared] : bindings) kinds.emplace_back(binding, declared.kind);
  return kinds;
}

}  // namespace

Reflection reflect_together(std::span<const std::span<const uint32_t>> modules) {
  try {
    return reflect_all(modules);
  } catch (const Unreadable& shader) {
    assertion_failed(__FILE__, __LINE__, shader.what());
  }
}

std::string misfit(std::string_view file, std::span<const uint32_t> words) {
  try {
    const Interface now = interface_of(words), before = interface_of(embedded_spirv(file));
    if (kinds_of(now.arguments) != kinds_of(before.arguments) || kinds_of(now.tables) != kinds_of(before.tables))
      return "its bindings have changed";
    if (now.arguments != before.arguments || now.tables != before.tables) return "its bindings' names have changed";
    return now.push_bytes == before.push_bytes ? "" : "its push constants have changed";
  } catch (const Unreadable& shader) {
    return shader.what();
  }
}

std::string names_of(std::span<const Declared> declared) {
  std::string text;
  for (const Declared& one : declared) text += (text.empty() ? "" : ", ") + one.name;
  return text.empty() ? "nothing" : text;
}

Reflection reflect(std::span<const uint32_t> spirv) { return reflect_together({&spirv, 1}); }

uint32_t declared_constant(std::string_view file, uint32_t constant_id) {
  const Module module = parse(embedded_spirv(file));
  for (const auto& [id, declared_id] : module.spec_id)
    if (declared_id == constant_id) return constant(module, id);
  CRSH_ASSERT(false, std::string(file) + " lacks the specialisation constant " + std::to_string(constant_id));
  return 0;
}

}  // namespace crsh::gpu
