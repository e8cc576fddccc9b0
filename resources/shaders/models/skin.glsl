// Skin: two specular lobes over a body that scatters: light that enters spreads before it leaves (subsurface_pass).
#define DERMIS_LOBES 2
#include "generated/material_block.glsl"
#include "material_maps.glsl"
#include "models/layered.glsl"

Shading shade(Surface s) {
  vec3 albedo = u_material.base_albedo.rgb * colourMap(u_map_albedo, kMapAlbedo, s.uv).rgb;
  float metallic = clamp(u_material.base_metallic * scalarMap(u_map_metallic, kMapMetallic, s.uv), 0.0, 1.0);
  float roughness = u_material.specular_perceptual_roughness * scalarMap(u_map_roughness, kMapRoughness, s.uv);
  float intensity = max(u_material.specular_intensity * scalarMap(u_map_specular, kMapSpecular, s.uv), 0.0);
  float cavity = clamp(u_material.specular_cavity * scalarMap(u_map_cavity, kMapCavity, s.uv), 0.0, 1.0);
  float ao = occlusionMap(s.uv, u_material.occlusion_strength);
  vec3 normal = mappedNormalWithDetail(s, u_material.surface_normal_strength, u_material.surface_detail_strength,
                                       u_material.surface_detail_tiling);

  Layer layer;
  layer.body_f0 = u_material.specular_f0.w > 0.5 ? u_material.specular_f0.rgb : vec3(F0_fromIor(u_material.specular_ior));
  layer.metal_f0 = albedo;
  layer.metallic = metallic;
  vec2 lobes = clamp(roughness * u_material.specular_lobe_scale, kMinPerceptualRoughness, 1.0);
  layer.first = Lobe(lobes.x, intensity * (1.0 - u_material.specular_lobe_mix));
  layer.second = Lobe(lobes.y, intensity * u_material.specular_lobe_mix);

  LayerPoint p = layerPoint(layer, normal, s.view);
  LayerLight lamps = layerLamps(layer, p, s.position, facingNormal(s));
  LayerLight image = layerImage(layer, p, facingNormal(s), ao);

  // albedo^m goes in, albedo^(1 − m) comes out: m = 0 keeps texture detail sharp (d'Eon & Luebke 2007, GPU Gems 3, section 14.4).
  vec3 safe_albedo = max(albedo, vec3(1e-5));
  vec3 inwards = pow(safe_albedo, vec3(u_material.subsurface_albedo_mix));

  Shading result;
  result.entering = inHalfRange(inwards * (lamps.body + image.body));
  result.exit = p.body_out * (safe_albedo / inwards);
  result.subsurface = clamp(u_material.subsurface_weight * scalarMap(u_map_subsurface, kMapSubsurface, s.uv), 0.0, 1.0);
  result.transmission = vec3(0.0);
  result.thickness_mm = 0.0;
  result.energy = layerEnergy(p, albedo, cavity);
  // Pores and creases swallow reflections; what they swallow is not diffused either.
  result.specular = inHalfRange(cavity * (lamps.specular + image.specular));
  result.alpha = 1.0;
  result.occlusion = ao;
  result.shading_normal = normal;
  return result;
}
