// Reflections of the environment as an integral, for pictures that are averaged over samples.
//
// The split sum takes the prefiltered environment for a lobe that is round (N = V = R). At grazing angles a lobe is stretched along
// the plane of incidence, and a lamp behind the rim of a face shines far brighter than the split sum has it. Each sample of a still
// picture therefore draws one direction a lobe from the visible normals, looks up the environment prefiltered to that sample's solid
// angle (Křivánek & Colbert 2008, "Real-time Shading with Filtered Importance Sampling", equation 5), and corrects the split sum, which
// serves as control variate: in a constant environment nothing is left to correct, so there is no noise and no energy lost.
#ifndef DERMIS_LOBE_SAMPLING
#define DERMIS_LOBE_SAMPLING

#include "brdf.glsl"
#include "frame_block.glsl"
#include "lighting/environment.glsl"

// Number of directions of this sample: none while moving, nor for pictures of a few samples, which would stay noisy. A still picture
// begins without, so that it doesn't flicker when a drag ends; the later samples make up for that. Software GL
// would run through all of it to add nothing while moving.
const int kSmoothSamples = 8;
#ifdef DERMIS_MOVING
int lobeSamples() { return 0; }
#else
int lobeSamples() { return u_sampling.w >= 32 && u_sampling.x >= kSmoothSamples ? 1 : 0; }
#endif
float lobeShare() { return float(u_sampling.w) / float(max(u_sampling.w - kSmoothSamples, 1)); }

// Evenly spread over the samples: the R2 sequence (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences"). The same for
// all pixels, because directions as wide as these overlap: what error is left varies as smoothly as the lobe, and there is no grain.
vec2 lobeRandom(vec2 shift) {
  return fract(shift + float(u_sampling.x - kSmoothSamples) * vec2(0.7548776662466927, 0.5698402909980532));
}

// A microfacet normal that is visible from v; both in the frame whose z is the normal: Dupuy & Benyoub 2023, "Sampling Visible GGX
// Normals with Spherical Caps", listing 3.
vec3 visibleNormal(vec3 v, float alpha, vec2 u) {
  vec3 w = normalize(vec3(alpha * v.xy, v.z));
  float phi = 2.0 * kPi * u.x;
  float z = (1.0 - u.y) * (1.0 + w.z) - w.z;
  float s = sqrt(clamp(1.0 - z * z, 0.0, 1.0));
  vec3 h = vec3(s * cos(phi), s * sin(phi), z) + w;
  return normalize(vec3(alpha * h.xy, h.z));
}

// What one direction adds to `split_sum` = reflectance · mean, the environment's `mean` radiance for the round lobe.
// at_normal + at_grazing (1 − v·h)⁵ is the lobe's Fresnel reflectance with its weight and compensation.
vec3 lobeCorrection(vec3 normal, vec3 view, float n_dot_v, float perceptual_roughness, vec3 at_normal, vec3 at_grazing, float root_v,
                    vec3 mean, vec2 u) {
  float alpha = perceptual_roughness * perceptual_roughness;
  float alpha2 = alpha * alpha;
  // Duff et al. 2017, "Building an Orthonormal Basis, Revisited", listing 3: turns only where the surface faces −Z.
  float side = normal.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (side + normal.z);
  float b = normal.x * normal.y * a;
  vec3 x = vec3(1.0 + side * normal.x * normal.x * a, side * b, -side * normal.x);
  vec3 y = vec3(b, side + normal.y * normal.y * a, -normal.y);
  // Interpolated normals turn away from the viewer at silhouettes: there the view keeps its n·v.
  vec2 across = vec2(dot(view, x), dot(view, y));
  vec3 v = vec3(across * (sqrt(max(1.0 - n_dot_v * n_dot_v, 0.0)) / max(length(across), 1e-6)), n_dot_v);

  vec3 h = visibleNormal(v, alpha, u);
  float v_dot_h = max(dot(v, h), 1e-6);
  vec3 l = 2.0 * v_dot_h * h - v;
  float n_dot_l = l.z;
  if (n_dot_l <= 0.0) return vec3(0.0);

  // The weight is the lobe over the density: F G₂ / G₁, heights correlated.
  float root_l = smithRoot(n_dot_l, alpha2);
  float g2_over_g1 = n_dot_l * (n_dot_v + root_v) / max(n_dot_l * root_v + n_dot_v * root_l, 1e-12);
  vec3 weight = (at_normal + at_grazing * pow5(1.0 - min(v_dot_h, 1.0))) * g2_over_g1;

  // Of l: G₁ D / (4 n·v).
  float density = D_GGX(h.z, dot(h.xy, h.xy), alpha) * 0.5 / max(n_dot_v + root_v, 1e-6);
  // A lobe round N = V = R of width a² covers about 4π a⁴. A sixteenth of the lobe a direction, whatever the number of samples:
  // narrower would be noise where a small lamp meets a wide lobe, wider blurs lamps (sphere_reflection_test.cpp has the figures).
  const float kDirections = 16.0;
  float filter_alpha2 = 1.0 / (4.0 * kPi * kDirections * max(density, 1e-6));
  float filter_roughness = min(sqrt(sqrt(filter_alpha2)), perceptual_roughness);
  vec3 world = x * l.x + y * l.y + normal * l.z;
  return lobeShare() * weight * (environmentPrefiltered(world, filter_roughness) - mean);
}

#endif
