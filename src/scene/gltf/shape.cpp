#include "scene/gltf/shape.h"

#include <tiny_gltf.h>

namespace crsh::scene {

namespace {

// Short ways to write a row.
constexpr Field index(std::string_view name) { return {name, Kind::index}; }
constexpr Field length(std::string_view name) { return {name, Kind::length}; }
constexpr Field number(std::string_view name) { return {name, Kind::number}; }
constexpr Field numbers(std::string_view name, size_t count) { return {name, Kind::numbers, count}; }
constexpr Field flag(std::string_view name) { return {name, Kind::flag}; }
constexpr Field text(std::string_view name) { return {name, Kind::text}; }
constexpr Field indices(std::string_view name) { return {name, Kind::indices}; }
constexpr Field texts(std::string_view name) { return {name, Kind::texts}; }
constexpr Field object(std::string_view name, const Shape& shape) { return {name, Kind::object, 0, &shape}; }
constexpr Field list(std::string_view name, const Shape& shape) { return {name, Kind::list, 0, &shape}; }
constexpr Field may_break(Field field, std::string_view json) { return field.stand_in = json, field; }
constexpr Field needed(Field field) { return field.needed = true, field; }
constexpr Field filled(Field field, std::string_view json) { return field.fill = json, field; }

// Files, data and accessors (glTF 2.0, section 5).
constexpr Field asset_fields[] = {text("version"), text("minVersion")};
constexpr Shape asset{asset_fields};
constexpr Field buffer_fields[] = {length("byteLength"), text("uri")};
constexpr Shape buffer{buffer_fields, sizeof(tinygltf::Buffer)};
constexpr Field meshopt_fields[] = {needed(index("buffer")),
                                    length("byteOffset"),
                                    needed(length("byteLength")),
                                    needed(length("byteStride")),
                                    needed(length("count")),
                                    needed(text("mode")),
                                    text("filter")};
constexpr Shape meshopt{meshopt_fields};
constexpr Field view_extension_fields[] = {object("EXT_meshopt_compression", meshopt),
                                           object("KHR_meshopt_compression", meshopt)};
constexpr Shape view_extensions{view_extension_fields};
constexpr Field view_fields[] = {needed(index("buffer")), length("byteOffset"), needed(length("byteLength")),
                                 length("byteStride"), object("extensions", view_extensions)};
constexpr Shape view{view_fields, sizeof(tinygltf::BufferView)};
constexpr Field sparse_indices_fields[] = {needed(index("bufferView")), index("byteOffset"),
                                           needed(index("componentType"))};
constexpr Shape sparse_indices{sparse_indices_fields};
constexpr Field sparse_values_fields[] = {needed(index("bufferView")), index("byteOffset")};
constexpr Shape sparse_values{sparse_values_fields};
constexpr Field sparse_fields[] = {needed(index("count")), needed(object("indices", sparse_indices)),
                                   needed(object("values", sparse_values))};
constexpr Shape sparse{sparse_fields};
constexpr Field accessor_fields[] = {
    index("bufferView"),     length("byteOffset"), flag("normalized"),      needed(index("componentType")),
    needed(length("count")), needed(text("type")), object("sparse", sparse)};
constexpr Shape accessor{accessor_fields, sizeof(tinygltf::Accessor)};

// Meshes and nodes.
constexpr Field attribute_fields[] = {index("POSITION"), index("NORMAL"),     index("TANGENT"),  index("COLOR_0"),
                                      index("COLOR_1"),  index("TEXCOORD_*"), index("JOINTS_*"), index("WEIGHTS_*")};
constexpr Shape attributes{attribute_fields};
constexpr Field target_fields[] = {index("POSITION"), index("NORMAL"), index("TANGENT")};
constexpr Shape target{target_fields, 4 * sizeof(std::map<std::string, int>)};
constexpr Field draco_fields[] = {needed(index("bufferView")), needed(object("attributes", attributes))};
constexpr Shape draco{draco_fields};
constexpr Field mapping_fields[] = {needed(index("material")), needed(indices("variants"))};
constexpr Shape mapping{mapping_fields, sizeof(tinygltf::Value)};
constexpr Field mappings_fields[] = {list("mappings", mapping)};
constexpr Shape mappings{mappings_fields};
constexpr Field primitive_extension_fields[] = {object("KHR_draco_mesh_compression", draco),
                                                object("KHR_materials_variants", mappings)};
constexpr Shape primitive_extensions{primitive_extension_fields};
constexpr Field primitive_fields[] = {needed(object("attributes", attributes)),
                                      index("indices"),
                                      index("material"),
                                      index("mode"),
                                      list("targets", target),
                                      object("extensions", primitive_extensions)};
constexpr Shape primitive{primitive_fields, sizeof(tinygltf::Primitive)};
constexpr Field mesh_fields[] = {text("name"), list("primitives", primitive), numbers("weights", 0)};
constexpr Shape mesh{mesh_fields, sizeof(tinygltf::Mesh)};
constexpr Field node_light_fields[] = {needed(index("light"))};
constexpr Shape node_light{node_light_fields};
constexpr Field instancing_attribute_fields[] = {index("TRANSLATION"), index("ROTATION"), index("SCALE")};
constexpr Shape instancing_attributes{instancing_attribute_fields};
constexpr Field instancing_fields[] = {object("attributes", instancing_attributes)};
constexpr Shape instancing{instancing_fields};
constexpr Field visibility_fields[] = {filled(flag("visible"), "true")};
constexpr Shape visibility{visibility_fields};
constexpr Field node_extension_fields[] = {object("EXT_mesh_gpu_instancing", instancing),
                                           object("KHR_lights_punctual", node_light),
                                           object("KHR_node_visibility", visibility)};
constexpr Shape node_extensions{node_extension_fields};
constexpr Field node_fields[] = {text("name"),
                                 index("camera"),
                                 index("mesh"),
                                 index("skin"),
                                 indices("children"),
                                 numbers("matrix", 16),
                                 numbers("rotation", 4),
                                 numbers("scale", 3),
                                 numbers("translation", 3),
                                 numbers("weights", 0),
                                 object("extensions", node_extensions)};
constexpr Shape node{node_fields, sizeof(tinygltf::Node)};
constexpr Field scene_fields[] = {text("name"), indices("nodes")};
constexpr Shape scene{scene_fields, sizeof(tinygltf::Scene)};
constexpr Field skin_fields[] = {filled(indices("joints"), "[]"), index("inverseBindMatrices")};
constexpr Shape skin{skin_fields, sizeof(tinygltf::Skin)};

// Materials and textures.
constexpr Field transform_fields[] = {filled(number("rotation"), "0.0"),  // tinygltf drops empty objects
                                      numbers("offset", 2), numbers("scale", 2), index("texCoord")};
constexpr Shape transform{transform_fields};
constexpr Field texture_extension_fields[] = {object("KHR_texture_transform", transform)};
constexpr Shape texture_extensions{texture_extension_fields};
constexpr Field texture_use_fields[] = {needed(index("index")), index("texCoord"),
                                        object("extensions", texture_extensions)};
constexpr Shape texture_use{texture_use_fields};
constexpr Field normal_fields[] = {needed(index("index")), index("texCoord"), number("scale"),
                                   object("extensions", texture_extensions)};
constexpr Shape normal_use{normal_fields};
constexpr Field occlusion_fields[] = {needed(index("index")), index("texCoord"), number("strength"),
                                      object("extensions", texture_extensions)};
constexpr Shape occlusion_use{occlusion_fields};
constexpr Field roughness_fields[] = {numbers("baseColorFactor", 4), number("metallicFactor"),
                                      number("roughnessFactor"), object("baseColorTexture", texture_use),
                                      object("metallicRoughnessTexture", texture_use)};
constexpr Shape roughness{roughness_fields};
constexpr Field strength_fields[] = {number("emissiveStrength")};
constexpr Shape strength{strength_fields};
constexpr Field ior_fields[] = {number("ior")};
constexpr Shape ior{ior_fields};
constexpr Field transmission_fields[] = {number("transmissionFactor"), object("transmissionTexture", texture_use)};
constexpr Shape transmission{transmission_fields};
constexpr Field volume_fields[] = {number("thicknessFactor"), object("thicknessTexture", texture_use),
                                   number("attenuationDistance"), numbers("attenuationColor", 3)};
constexpr Shape volume{volume_fields};
constexpr Field unlit_fields[] = {filled(flag("crsh"), "true")};  // so that it is no empty object
constexpr Shape unlit{unlit_fields};
constexpr Field specular_fields[] = {number("specularFactor"), object("specularTexture", texture_use),
                                     numbers("specularColorFactor", 3), object("specularColorTexture", texture_use)};
constexpr Shape specular{specular_fields};
constexpr Field clearcoat_fields[] = {filled(number("clearcoatFactor"), "0.0"), object("clearcoatTexture", texture_use),
                                      number("clearcoatRoughnessFactor"),
                                      object("clearcoatRoughnessTexture", texture_use),
                                      object("clearcoatNormalTexture", normal_use)};
constexpr Shape clearcoat{clearcoat_fields};
constexpr Field sheen_fields[] = {numbers("sheenColorFactor", 3), object("sheenColorTexture", texture_use),
                                  filled(number("sheenRoughnessFactor"), "0.0"),
                                  object("sheenRoughnessTexture", texture_use)};
constexpr Shape sheen{sheen_fields};
constexpr Field iridescence_fields[] = {filled(number("iridescenceFactor"), "0.0"),
                                        object("iridescenceTexture", texture_use),
                                        number("iridescenceIor"),
                                        number("iridescenceThicknessMinimum"),
                                        number("iridescenceThicknessMaximum"),
                                        object("iridescenceThicknessTexture", texture_use)};
constexpr Shape iridescence{iridescence_fields};
constexpr Field anisotropy_fields[] = {filled(number("anisotropyStrength"), "0.0"), number("anisotropyRotation"),
                                       object("anisotropyTexture", texture_use)};
constexpr Shape anisotropy{anisotropy_fields};
constexpr Field dispersion_fields[] = {filled(number("dispersion"), "0.0")};
constexpr Shape dispersion{dispersion_fields};
constexpr Field diffuse_transmission_fields[] = {
    filled(number("diffuseTransmissionFactor"), "0.0"), object("diffuseTransmissionTexture", texture_use),
    numbers("diffuseTransmissionColorFactor", 3), object("diffuseTransmissionColorTexture", texture_use)};
constexpr Shape diffuse_transmission{diffuse_transmission_fields};
constexpr Field glossiness_fields[] = {numbers("diffuseFactor", 4), object("diffuseTexture", texture_use),
                                       numbers("specularFactor", 3), filled(number("glossinessFactor"), "1.0"),
                                       object("specularGlossinessTexture", texture_use)};
constexpr Shape glossiness{glossiness_fields};
constexpr Field material_extension_fields[] = {object("KHR_materials_emissive_strength", strength),
                                               object("KHR_materials_ior", ior),
                                               object("KHR_materials_transmission", transmission),
                                               object("KHR_materials_volume", volume),
                                               object("KHR_materials_unlit", unlit),
                                               object("KHR_materials_specular", specular),
                                               object("KHR_materials_clearcoat", clearcoat),
                                               object("KHR_materials_sheen", sheen),
                                               object("KHR_materials_iridescence", iridescence),
                                               object("KHR_materials_anisotropy", anisotropy),
                                               object("KHR_materials_dispersion", dispersion),
                                               object("KHR_materials_diffuse_transmission", diffuse_transmission),
                                               object("KHR_materials_pbrSpecularGlossiness", glossiness)};
constexpr Shape material_extensions{material_extension_fields};
constexpr Field material_fields[] = {text("name"),
                                     flag("doubleSided"),
                                     text("alphaMode"),
                                     number("alphaCutoff"),
                                     numbers("emissiveFactor", 3),
                                     object("emissiveTexture", texture_use),
                                     object("normalTexture", normal_use),
                                     object("occlusionTexture", occlusion_use),
                                     object("pbrMetallicRoughness", roughness),
                                     object("extensions", material_extensions)};
constexpr Shape material{material_fields, sizeof(tinygltf::Material)};
constexpr Field other_image_fields[] = {index("source")};
constexpr Shape other_image{other_image_fields};
constexpr Field texture_file_fields[] = {object("KHR_texture_basisu", other_image),
                                         object("EXT_texture_webp", other_image),
                                         object("EXT_texture_avif", other_image)};
constexpr Shape texture_files{texture_file_fields};
constexpr Field texture_fields[] = {index("source"), index("sampler"), object("extensions", texture_files)};
constexpr Shape texture{texture_fields, sizeof(tinygltf::Texture)};
constexpr Field sampler_fields[] = {index("magFilter"), index("minFilter"), index("wrapS"), index("wrapT")};
constexpr Shape sampler{sampler_fields, sizeof(tinygltf::Sampler)};
constexpr Field image_fields[] = {index("bufferView"), text("uri")};
constexpr Shape image{image_fields, sizeof(tinygltf::Image)};

// Cameras and lights.
constexpr Field perspective_fields[] = {needed(number("yfov")), needed(number("znear")), filled(number("zfar"), "0"),
                                        number("aspectRatio")};
constexpr Shape perspective{perspective_fields};
constexpr Field orthographic_fields[] = {needed(number("xmag")), needed(number("ymag")), filled(number("znear"), "0"),
                                         filled(number("zfar"), "0")};
constexpr Shape orthographic{orthographic_fields};
constexpr Field camera_fields[] = {text("name"), filled(text("type"), "\"\""), object("perspective", perspective),
                                   object("orthographic", orthographic)};
constexpr Shape camera{camera_fields, sizeof(tinygltf::Camera)};
constexpr Field spot_fields[] = {number("innerConeAngle"), number("outerConeAngle")};
constexpr Shape spot{spot_fields};
constexpr Field light_fields[] = {text("name"),        filled(text("type"), "\"\""),
                                  numbers("color", 3), number("intensity"),
                                  number("range"),     filled(object("spot", spot), "{}")};
constexpr Shape light{light_fields, sizeof(tinygltf::Light) + 6 * sizeof(tinygltf::Value)};
constexpr Field lights_fields[] = {may_break(list("lights", light), R"({"type":"","spot":{}})")};
constexpr Shape lights{lights_fields};
constexpr Field variant_fields[] = {filled(text("name"), "\"\"")};
constexpr Shape variant{variant_fields, sizeof(tinygltf::Value)};
constexpr Field variants_fields[] = {list("variants", variant)};
constexpr Shape variants{variants_fields};
constexpr Field root_extension_fields[] = {object("KHR_lights_punctual", lights),
                                           object("KHR_materials_variants", variants)};
constexpr Shape root_extensions{root_extension_fields};

// Animations.
constexpr Field pointer_fields[] = {needed(text("pointer"))};
constexpr Shape pointer{pointer_fields};
constexpr Field target_extension_fields[] = {object("KHR_animation_pointer", pointer)};
constexpr Shape target_extensions{target_extension_fields};
constexpr Field channel_target_fields[] = {filled(index("node"), "-1"), filled(text("path"), "\"\""),
                                           object("extensions", target_extensions)};
constexpr Shape channel_target{channel_target_fields};
constexpr Field channel_fields[] = {needed(object("target", channel_target)), needed(index("sampler"))};
constexpr Shape channel{channel_fields, sizeof(tinygltf::AnimationChannel)};
constexpr Field keys_fields[] = {needed(index("input")), needed(index("output")), text("interpolation")};
constexpr Shape keys{keys_fields, sizeof(tinygltf::AnimationSampler)};
constexpr Field animation_fields[] = {text("name"), list("channels", channel), list("samplers", keys)};
constexpr Shape animation{animation_fields, sizeof(tinygltf::Animation)};

constexpr Field root_fields[] = {object("asset", asset),
                                 texts("extensionsUsed"),
                                 list("buffers", buffer),
                                 list("bufferViews", view),
                                 may_break(list("accessors", accessor), accessor_stand_in),
                                 list("meshes", mesh),
                                 list("nodes", node),
                                 list("scenes", scene),
                                 index("scene"),
                                 list("skins", skin),
                                 list("materials", material),
                                 list("textures", texture),
                                 list("samplers", sampler),
                                 list("images", image),
                                 may_break(list("cameras", camera), camera_stand_in),
                                 list("animations", animation),
                                 object("extensions", root_extensions)};

}  // namespace

const Shape root_shape{root_fields, 0};

}  // namespace crsh::scene
