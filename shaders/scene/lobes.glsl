// The lobes of a material at a point of a drawn triangle, and what they change of the surface that `surface_of` found.
// For the raster pass's surfaces and for the hits of every bounce.

#include "lib/bsdf.glsl"
#include "scene/surface.glsl"

const uint first_lobe_slot = slot_specular;
const uint slots_of_lobes = ~((1u << first_lobe_slot) - 1u);

/// What the textures of a material's lobes hold at a point, by slot; white where it has none.
struct LobeTexels {
  vec4 of[slot_count - first_lobe_slot];
};

LobeTexels lobe_texels_at(Material material, Attributes at, Point point, vec3 incoming) {
  LobeTexels found;
  for (uint i = 0u; i < slot_count - first_lobe_slot; ++i) found.of[i] = vec4(1.0);
  uvec3 uv_metrics = stored_triangle(stored_of(point.triangle)).uv_metrics;
  float footprint = footprint_on(point, incoming);
  for (uint left = material.slots & slots_of_lobes; left != 0u; left &= left - 1u) {
    uint slot = uint(findLSB(left));
    found.of[slot - first_lobe_slot] = texel_of(material, slot, at, uv_metrics, point.area, footprint);
  }
  return found;
}

vec4 texel_of_slot(LobeTexels texels, uint slot) { return texels.of[slot - first_lobe_slot]; }

bool has_slot(Material material, uint slot) { return (material.slots & 1u << slot) != 0u; }

/// KHR_materials_specular: the dielectric's F0 is coloured, and all that it reflects is scaled.
void apply_specular(Lobes from, LobeTexels texels, vec3 f0, inout SurfaceLobes lobes) {
  float factor = clamp(from.specular.w * texel_of_slot(texels, slot_specular).a, 0.0, 1.0);
  vec3 colour = from.specular.rgb * texel_of_slot(texels, slot_specular_colour).rgb;
  lobes.dielectric = min(f0 * colour, vec3(1.0)) * factor * (1.0 - lobes.metallic);
  lobes.f90 = mix(factor, 1.0, lobes.metallic);
}

/// KHR_materials_pbrSpecularGlossiness: the file gives F0 itself; `found.diffuse` is base colour as yet.
void apply_glossiness(Lobes from, LobeTexels texels, inout Surface found, inout SurfaceLobes lobes) {
  vec4 glossy = from.glossiness * texel_of_slot(texels, slot_specular_glossiness);
  lobes.dielectric = min(glossy.rgb, vec3(1.0));
  found.diffuse *= 1.0 - largest_channel(lobes.dielectric);
  found.roughness = 1.0 - clamp(glossy.a, 0.0, 1.0);
}

void apply_clearcoat(Lobes from, LobeTexels texels, inout SurfaceLobes lobes) {
  lobes.coat = clamp(from.clearcoat.x * texel_of_slot(texels, slot_clearcoat).r, 0.0, 1.0);
  lobes.coat_roughness = clamp(from.clearcoat.y * texel_of_slot(texels, slot_clearcoat_roughness).g, 0.0, 1.0);
}

void apply_sheen(Lobes from, LobeTexels texels, inout SurfaceLobes lobes) {
  lobes.sheen = min(from.sheen.rgb * texel_of_slot(texels, slot_sheen_colour).rgb, vec3(1.0));
  lobes.sheen_roughness = clamp(from.sheen.w * texel_of_slot(texels, slot_sheen_roughness).a, 0.0, 1.0);
}

void apply_iridescence(Lobes from, LobeTexels texels, inout SurfaceLobes lobes) {
  lobes.film = clamp(from.iridescence.x * texel_of_slot(texels, slot_iridescence).r, 0.0, 1.0);
  lobes.film_ior = from.iridescence.y;
  lobes.film_thickness =
      mix(from.iridescence.z, from.iridescence.w, texel_of_slot(texels, slot_iridescence_thickness).g);
}

/// KHR_materials_anisotropy: the texture turns the tangent (red, green) and scales the strength (blue). Where the mesh
/// has no tangents the surface stays isotropic.
void apply_anisotropy(Material material, Lobes from, LobeTexels texels, Point point, vec3 interpolated, vec3 normal,
                      inout SurfaceLobes lobes) {
  vec3 texel = texel_of_slot(texels, slot_anisotropy).rgb;
  vec2 way = has_slot(material, slot_anisotropy) ? texel.rg * 2.0 - 1.0 : vec2(1.0, 0.0);
  vec2 turned = vec2(from.anisotropy.y * way.x - from.anisotropy.z * way.y,
                     from.anisotropy.z * way.x + from.anisotropy.y * way.y);
  TangentFrame frame = frame_at(point, interpolated);
  if (has_slot(material, slot_anisotropy)) frame = turned_frame(frame, use_of(material, slot_anisotropy).matrix);
  vec3 along = frame.tangent * turned.x + frame.bitangent * turned.y;
  along -= normal * dot(normal, along);
  if (!(dot(along, along) > 1e-6)) return;
  lobes.tangent = normalize(along);
  lobes.anisotropy = clamp(from.anisotropy.x * texel.b, 0.0, 1.0);
}

void apply_diffuse_transmission(Lobes from, LobeTexels texels, Surface found, inout SurfaceLobes lobes) {
  lobes.through_share =
      clamp(from.diffuse_transmission.w * texel_of_slot(texels, slot_diffuse_transmission).a, 0.0, 1.0);
  vec3 colour = from.diffuse_transmission.rgb * texel_of_slot(texels, slot_diffuse_transmission_colour).rgb;
  lobes.through = min(colour, vec3(1.0)) * lobes.through_share * (1.0 - found.metallic) * (1.0 - found.transmission);
}

/// KHR_materials_volume: which solid lies on either side; none where the thickness texture says that the wall is thin.
void apply_volume(Material material, Lobes from, LobeTexels texels, bool front, inout Surface found,
                  inout SurfaceLobes lobes) {
  if (!bends(material)) return;
  if (texel_of_slot(texels, slot_thickness).g == 0.0) {
    found.eta = 1.0;
    return;
  }
  float own = largest_channel(from.attenuation.rgb) > 0.0 ? float(material.lobes + 1u) : 0.0;
  lobes.medium = front ? 0.0 : own;
  lobes.medium_behind = front ? own : 0.0;
}

/// The normal of the coat: of its own map, else as interpolated.
vec3 coat_normal_of(Material material, Lobes from, LobeTexels texels, Point point, vec3 interpolated, vec3 geometric,
                    vec3 incoming) {
  if (!has_slot(material, slot_clearcoat_normal)) return shading_normal(interpolated, geometric, incoming);
  vec3 texel = texel_of_slot(texels, slot_clearcoat_normal).xyz;
  return tilted_normal(point, interpolated, geometric, texel, from.clearcoat.z,
                       use_of(material, slot_clearcoat_normal).matrix, incoming);
}

/// KHR_materials_unlit: base colour is emitted, nothing is reflected.
SurfaceLobes unlit_lobes(inout Surface found) {
  SurfaceLobes lobes = no_lobes(found.normal, 0.0, 0.0);
  lobes.unlit = true;
  lobes.f90 = 0.0;
  found.emission = found.diffuse;
  found.diffuse = found.specular = vec3(0.0);
  return lobes;
}

/// The lobes of a surface, which they change; `point` needs its weights.
SurfaceLobes lobes_of(Material material, Attributes at, Point point, vec3 incoming, inout Surface found) {
  float share = dielectric_share(material, found.metallic);
  SurfaceLobes lobes = no_lobes(found.normal, share, found.metallic);
  if (material.lobes == none) return lobes;
  if ((material.flags & material_unlit) != 0u) return unlit_lobes(found);
  Lobes from = lobes_at(material.lobes);
  LobeTexels texels = lobe_texels_at(material, at, point, incoming);
  vec3 metal = found.specular - share;
  if ((material.flags & material_specular_glossiness) != 0u) apply_glossiness(from, texels, found, lobes);
  else apply_specular(from, texels, vec3(dielectric_f0(material.body.z)), lobes);
  found.specular = lobes.dielectric + metal;
  apply_clearcoat(from, texels, lobes);
  lobes.coat_normal = coat_normal_of(material, from, texels, point, at.normal, found.geometric, incoming);
  apply_sheen(from, texels, lobes);
  apply_iridescence(from, texels, lobes);
  apply_anisotropy(material, from, texels, point, at.normal, found.normal, lobes);
  apply_diffuse_transmission(from, texels, found, lobes);
  apply_volume(material, from, texels, meets_front(point.front, incoming), found, lobes);
  found.emission *= 1.0 - coat_reflectance(lobes, -incoming);
  return lobes;
}
