// The shader of "Physically Based Skin rendering Using OpenGL" (2024), as published. docs/seed-shaders.md says what was chosen
// where its text is silent. The display's half, c/(c+1) and pow 1/2.2, is the view "Thesis".
#include "brdf.glsl"
#include "frame_block.glsl"
#include "generated/material_block.glsl"
#include "lighting/dfg.glsl"
#include "lighting/environment.glsl"
#include "lights.glsl"
#include "material_maps.glsl"

// What the published code reads from the maps.
struct ThesisPoint {
  vec3 albedo;
  vec3 normal;
  float metallic;
  float roughness;  // alpha = roughness² in D, roughness itself in both k
  float ao;
  vec3 f0s;  // mix(F0, specular, metallic) with F0 = mix(0.04, albedo, metallic)
};

ThesisPoint thesisPoint(Surface s) {
  ThesisPoint p;
  // The map is bound without sRGB decoding: the published code decodes with pow 2.2.
  p.albedo = u_material.base_albedo.rgb * pow(colourMap(u_map_albedo, kMapAlbedo, s.uv).rgb, vec3(2.2));
  p.normal = mappedNormal(s, 1.0).normal;
  p.metallic = u_material.base_metallic * scalarMap(u_map_metallic, kMapMetallic, s.uv);
  p.roughness = u_material.specular_perceptual_roughness * scalarMap(u_map_roughness, kMapRoughness, s.uv);
  p.ao = occlusionMap(s.uv, u_material.occlusion_strength);
  float specular = u_material.specular_intensity * scalarMap(u_map_specular, kMapSpecular, s.uv);
  vec3 f0 = mix(vec3(0.04), p.albedo, p.metallic);
  p.f0s = mix(f0, vec3(specular), p.metallic);
  return p;
}

vec3 thesisSubsurface(float n_dot_l) {
  return u_material.thesis_sss_color.rgb *
         (1.0 - exp(-u_material.thesis_thickness * u_material.thesis_sss_scale * n_dot_l));
}

// One light's diffuse and wrap term, and its Cook-Torrance specular.
void thesisLight(ThesisPoint p, vec3 view, float n_dot_v, LightSample light, inout vec3 diffuse, inout vec3 specular) {
  float n_dot_l = max(dot(p.normal, light.to_light), 0.0);
  vec3 h = normalize(light.to_light + view);
  float n_dot_h = max(dot(p.normal, h), 0.0);
  vec3 n_cross_h = cross(p.normal, h);
  float d = D_GGX(n_dot_h, dot(n_cross_h, n_cross_h), p.roughness * p.roughness);
  float g = G_SmithSchlickGGX(n_dot_v, n_dot_l, k_SchlickGGXLamp(p.roughness));
  vec3 f = F_Schlick(p.f0s, max(dot(h, view), 0.0));
  vec3 kd = (vec3(1.0) - f) * (1.0 - p.metallic);
  vec3 received = light.irradiance * n_dot_l;
  diffuse += (kd * p.albedo * kInversePi + thesisSubsurface(n_dot_l)) * received;
  // The published 0.0001 keeps the quotient finite at grazing angles.
  specular += d * g * f / (4.0 * n_dot_v * n_dot_l + 0.0001) * received;
}

Shading shade(Surface s) {
  ThesisPoint p = thesisPoint(s);
  float n_dot_v = max(dot(p.normal, s.view), 0.0);

  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
#define ADD_LIGHT(number) thesisLight(p, s.view, n_dot_v, lightAt(number, s.position), diffuse, specular);
  EACH_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT

  // Ambient: Fresnel with roughness (Lagarde 2011), irradiance map, prefiltered map, DFG table of Schlick-GGX with k = roughness²/2.
  vec3 f = p.f0s + (max(vec3(1.0 - p.roughness), p.f0s) - p.f0s) * pow5(clamp(1.0 - n_dot_v, 0.0, 1.0));
  vec3 kd = (vec3(1.0) - f) * (1.0 - p.metallic);
  vec2 dfg = dfgSchlickIbl(n_dot_v, p.roughness);
  vec3 r = reflect(-s.view, p.normal);
  diffuse += p.ao * kd * p.albedo * environmentIrradiance(p.normal);
  specular += p.ao * (f * dfg.x + dfg.y) * environmentPrefiltered(r, p.roughness);

  Shading result = plainShading(min(diffuse, vec3(kRadianceMax)), min(specular, vec3(kRadianceMax)), 1.0, p.normal);
  result.occlusion = p.ao;
  return result;
}
