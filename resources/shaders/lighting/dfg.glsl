// The BRDF half of the split sum (Karis 2013, "Real Shading in Unreal Engine 4"): for Schlick's Fresnel with f90 = 1,
// the directional albedo is F0 · x + y. Tables by renderer/lighting/dfg_quadrature.h.
// Stored over sqrt(N·V), which resolves the boundary layer at grazing angles, and perceptual roughness; 0 and 1 of both
// lie on texel centres.
layout(binding = 18) uniform sampler2D u_dfg_smith;
layout(binding = 19) uniform sampler2D u_dfg_schlick_ibl;

vec2 dfgCoordinate(float n_dot_v, float perceptual_roughness, vec2 size) {
  vec2 c = clamp(vec2(sqrt(max(n_dot_v, 0.0)), perceptual_roughness), 0.0, 1.0);
  return (c * (size - 1.0) + 0.5) / size;
}

// Height-correlated Smith visibility.
vec2 dfgSmith(float n_dot_v, float perceptual_roughness) {
  return textureLod(u_dfg_smith, dfgCoordinate(n_dot_v, perceptual_roughness, vec2(textureSize(u_dfg_smith, 0))), 0.0)
      .rg;
}

// Schlick-GGX with k = roughness² / 2, of the published shader's tables.
vec2 dfgSchlickIbl(float n_dot_v, float perceptual_roughness) {
  return textureLod(u_dfg_schlick_ibl,
                    dfgCoordinate(n_dot_v, perceptual_roughness, vec2(textureSize(u_dfg_schlick_ibl, 0))), 0.0)
      .rg;
}
