// The lab's microfacet reflection of the environment, as published: encoded in the shader, so what is written is display-referred; its
// natural view is Raw.
#include "brdf.glsl"
#include "frame_block.glsl"
#include "generated/material_block.glsl"
#include "lighting/environment.glsl"
#include "surface_types.glsl"

// Words of microfacet_lab.geometry.
const int kGeometryOne = 0;
const int kGeometrySmith = 1;
const int kGeometryCookTorrance = 2;

// Masking of Schlick 1994 with the published constant alpha = 0.3, k = alpha²/2, on both sides.
float labSmith(float n_dot_v, float n_dot_l) {
  const float alpha = 0.3;
  return G_SmithSchlickGGX(n_dot_v, n_dot_l, alpha * alpha / 2.0);
}

// Cook & Torrance 1982, equation for G. With h = n, as here, it is 1 but for rounding.
float labCookTorrance(float n_dot_v, float n_dot_l, float n_dot_h, float v_dot_h) {
  float twice = 2.0 * n_dot_h / max(v_dot_h, 1e-6);
  return min(1.0, min(twice * n_dot_v, twice * n_dot_l));
}

Shading shade(Surface s) {
  vec3 n = facingNormal(s);
  vec3 v = s.view;
  vec3 l = reflect(-v, n);
  vec3 h = normalize(l + v);
  float n_dot_v = max(dot(n, v), 0.0);
  float n_dot_l = max(dot(n, l), 0.0);

  vec3 f0 = u_material.specular_f0.w > 0.5 ? u_material.specular_f0.rgb : vec3(F0_fromIor(u_material.specular_ior));
  float intensity = (f0.r + f0.g + f0.b) / 3.0;
  vec3 f = f0 + (vec3(1.0) - f0) * pow5(1.0 - n_dot_l) + 0.4 * (1.0 - intensity);
  float g = 1.0;
  if (u_material.microfacet_lab_geometry == kGeometrySmith) g = labSmith(n_dot_v, n_dot_l);
  if (u_material.microfacet_lab_geometry == kGeometryCookTorrance)
    g = labCookTorrance(n_dot_v, n_dot_l, max(dot(n, h), 0.0), max(dot(v, h), 0.0));
  vec3 light = environmentPrefiltered(l, u_material.specular_perceptual_roughness);
  vec3 d = pow(max(light, 0.0), vec3(1.0 / 2.2));

  // At the silhouette (n·l)² goes to 0: what no half float holds is clamped, black stays black.
  vec3 colour = (1.0 - intensity) * d + f * g * d / max(4.0 * n_dot_l * n_dot_l, 1e-12);
  return plainShading(vec3(0.0), min(colour, vec3(kHalfMax)), 1.0, n);
}
