// Light from the environment, prefiltered (see renderer/lighting/environment_map.h). Needs frame_block.glsl.
// Directions are in world space and of unit length; results are radiance, linear Rec.709, exposure included.
#include "frame_block.glsl"
#include "lighting/dfg.glsl"

layout(binding = 16) uniform samplerCubeArray u_env_prefiltered;
layout(binding = 17) uniform samplerCube u_env_irradiance;
layout(binding = 20) uniform samplerCube u_env_sharp;

// Irradiance / pi of a surface that faces n_world: 1 in a constant environment of radiance 1.
vec3 environmentIrradiance(vec3 n_world) {
  return textureLod(u_env_irradiance, mat3(u_environment_from_world) * n_world, 0.0).rgb * u_environment_scale.x;
}

// The radiance that a GGX lobe round r_world sees, weighted by D(h) (n.l) with n = v = r, normalised.
//
// 21 roughness nodes lie in three mip levels of seven layers, so one lookup is two bilinear fetches and a mix. They are
// spaced as prefilterNode() in renderer/lighting/roughness_nodes.h says; 0.1, 0.25, 0.5, 0.75 and 1 are nodes.
vec3 environmentPrefiltered(vec3 r_world, float perceptual_roughness) {
  float r = clamp(perceptual_roughness, 0.0, 1.0);
  float octaves = log2(max(r, 0.1));
  float node = 10.0 * min(r, 0.1) + (8.0 / 1.32192809) * min(octaves + 3.32192809, 1.32192809) +
               5.0 * clamp(octaves + 2.0, 0.0, 1.0) + 12.0 * clamp(r - 0.5, 0.0, 0.5);
#ifdef DERMIS_MOVING
  // A moving picture on software GL takes the nearest node: at most 7 % off in roughness.
  float nearest = floor(node + 0.5), nearest_level = floor((nearest + 0.5) / 7.0);
  vec4 place = vec4(mat3(u_environment_from_world) * r_world, nearest - 7.0 * nearest_level);
  return textureLod(u_env_prefiltered, place, nearest_level).rgb * u_environment_scale.x;
#endif
  float lower = clamp(floor(node + 1e-4), 0.0, 19.0);  // a node itself needs the same two texels whatever the rounding
  vec2 index = vec2(lower, lower + 1.0);
  vec2 level = floor((index + 0.5) / 7.0);
  vec2 layer = index - 7.0 * level;
  vec3 d = mat3(u_environment_from_world) * r_world;
  vec3 a = textureLod(u_env_prefiltered, vec4(d, layer.x), level.x).rgb;
  vec3 b = textureLod(u_env_prefiltered, vec4(d, layer.y), level.y).rgb;
  return mix(a, b, clamp(node - lower, 0.0, 1.0)) * u_environment_scale.x;
}

// The environment itself.
vec3 environmentSharp(vec3 d_world) {
  return textureLod(u_env_sharp, mat3(u_environment_from_world) * d_world, 0.0).rgb * u_environment_scale.x;
}
