// Eyeball: sclera and iris under two specular lobes.
//
// Where the iris is follows from the direction of the vertex normal, so that one mesh may hold both eyes and no centre has to be
// known: on an eyeball of radius r the normal at a distance ρ from the optical axis (+Z, where the head looks) leans by asin(ρ/r).
// r is the human mean. With an albedo map the iris is in the map, and the two colours tint it.
#define DERMIS_LOBES 2
#include "generated/material_block.glsl"
#include "material_maps.glsl"
#include "models/layered.glsl"

const float kEyeballRadiusMm = 12.0;

// Distance of a point of the eyeball from the optical axis, in mm; the back half counts as beyond its rim.
float distanceFromAxisMm(vec3 vertex_normal) {
  float leaning = length(vertex_normal.xy);
  return kEyeballRadiusMm * (vertex_normal.z > 0.0 ? leaning : 2.0 - leaning);
}

vec3 eyeAlbedo(float axis_mm) {
  // Half of the limbus lies on either side of the iris's rim.
  float half_width = max(0.5 * u_material.eye_limbus_width_mm, 1e-3);
  float from_rim = (axis_mm - u_material.eye_iris_radius_mm) / half_width;
  vec3 albedo = mix(u_material.eye_iris_color.rgb, u_material.eye_sclera_color.rgb, smoothstep(-1.0, 1.0, from_rim));
  float ring = u_material.eye_limbus_width_mm > 0.0 ? 1.0 - smoothstep(0.0, 1.0, abs(from_rim)) : 0.0;
  return albedo * (1.0 - u_material.eye_limbus_darkness * ring);
}

Shading shade(Surface s) {
  vec3 albedo = eyeAlbedo(distanceFromAxisMm(s.normal)) * colourMap(u_map_albedo, kMapAlbedo, s.uv).rgb;
  float roughness = u_material.specular_perceptual_roughness * scalarMap(u_map_roughness, kMapRoughness, s.uv);
  float intensity = max(u_material.specular_intensity * scalarMap(u_map_specular, kMapSpecular, s.uv), 0.0);
  float cavity = clamp(u_material.specular_cavity * scalarMap(u_map_cavity, kMapCavity, s.uv), 0.0, 1.0);
  vec3 share;
  float ao = skyShare(s, u_material.occlusion_strength, share);
  vec3 normal = mappedNormal(s, u_material.surface_normal_strength);

  Layer layer;
  layer.body_f0 = u_material.specular_f0.w > 0.5 ? u_material.specular_f0.rgb : vec3(F0_fromIor(u_material.specular_ior));
  layer.metal_f0 = vec3(1.0);
  layer.metallic = 0.0;
  vec2 lobes = clamp(roughness * u_material.specular_lobe_scale, kMinPerceptualRoughness, 1.0);
  layer.first = Lobe(lobes.x, intensity * (1.0 - u_material.specular_lobe_mix));
  layer.second = Lobe(lobes.y, intensity * u_material.specular_lobe_mix);

  LayerPoint p = layerPoint(layer, normal, s.view);
  LayerLight lamps = layerLamps(layer, p, s.position, facingNormal(s));
  LayerLight image = layerImage(layer, p, facingNormal(s), multiBounce(share, albedo), ao);

  vec3 specular = inHalfRange(cavity * (lamps.specular + image.specular));
  Shading result = plainShading(inHalfRange(lamps.body + image.body), specular, 1.0, normal);
  result.exit = p.body_out * albedo;
  result.occlusion = ao;
  result.energy = layerEnergy(p, albedo, cavity);
  return result;
}
