// glTF 2.0's material, with the specular layer that skin has: one lobe, F0 0.04 for dielectrics.
#define DERMIS_LOBES 1
#include "generated/material_block.glsl"
#include "material_maps.glsl"
#include "models/layered.glsl"

// Words of metallic_roughness.alpha_mode.
const int kAlphaOpaque = 0;
const int kAlphaMask = 1;
const int kAlphaBlend = 2;

Shading shade(Surface s) {
  vec4 texel = colourMap(u_map_albedo, kMapAlbedo, s.uv);
  vec3 albedo = u_material.base_albedo.rgb * texel.rgb;
  float metallic = clamp(u_material.base_metallic * scalarMap(u_map_metallic, kMapMetallic, s.uv), 0.0, 1.0);
  float roughness = u_material.specular_perceptual_roughness * scalarMap(u_map_roughness, kMapRoughness, s.uv);
  float ao = occlusionMap(s.uv, u_material.occlusion_strength);
  vec3 emission = u_material.metallic_roughness_emissive.rgb * u_material.metallic_roughness_emissive_strength *
                  colourMap(u_map_emissive, kMapEmissive, s.uv).rgb;
  MappedNormal mapped = mappedNormal(s, u_material.surface_normal_strength);
  vec3 normal = mapped.normal;

  float alpha = u_material.metallic_roughness_opacity * texel.a;
  int mode = u_material.metallic_roughness_alpha_mode;
  if (mode == kAlphaMask && alpha < u_material.metallic_roughness_alpha_cutoff) discard;
  if (mode != kAlphaBlend) alpha = 1.0;

  Layer layer;
  layer.body_f0 = vec3(0.04);
  layer.metal_f0 = albedo;
  layer.metallic = metallic;
  layer.first = Lobe(widenedRoughness(clamp(roughness, kMinPerceptualRoughness, 1.0), mapped.variance), 1.0);

  LayerPoint p = layerPoint(layer, normal, s.view);
  LayerLight lamps = layerLamps(layer, p, s.position, facingNormal(s));
  LayerLight image = layerImage(layer, p, facingNormal(s), SkyLight(vec3(ao), vec3(0.0), ao));

  // glTF's alpha is coverage: it thins the whole surface, its reflections too.
  vec3 specular = inHalfRange(alpha * (lamps.specular + image.specular + emission));
  Shading result = plainShading(inHalfRange(alpha * (lamps.body + image.body)), specular, alpha, normal);
  result.exit = p.body_out * albedo;
  result.occlusion = ao;
  result.energy = layerEnergy(p, albedo, 1.0);
  return result;
}
