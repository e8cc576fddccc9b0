// The lobes, each with its source. `alpha` is the width of the microfacet distribution, the square of the perceptual
// roughness (Burley 2012, "Physically-Based Shading at Disney", section 5.4). Needs no uniform, so that tests can
// include it alone.
#ifndef DERMIS_BRDF
#define DERMIS_BRDF

const float kPi = 3.14159265358979;
const float kInversePi = 0.318309886183791;
const float kMinPerceptualRoughness = 0.02;  // the hard range of specular.perceptual_roughness
const float kMinNdotV = 1e-4;                // interpolated normals turn away from the camera at silhouettes
const float kHalfMax = 65504.0;              // pictures are half floats
const float kRadianceMax = 0.5 * kHalfMax;   // diffuse and specular are added

float pow5(float x) {
  float x2 = x * x;
  return x2 * x2 * x;
}

// Reflectance at normal incidence of a dielectric in air: Fresnel's equations at 0°.
float F0_fromIor(float ior) {
  float r = (ior - 1.0) / (ior + 1.0);
  return r * r;
}

// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", equation 15: everything is a mirror at 90°.
vec3 F_Schlick(vec3 f0, float v_dot_h) { return f0 + (vec3(1.0) - f0) * pow5(clamp(1.0 - v_dot_h, 0.0, 1.0)); }

// Trowbridge & Reitz 1975; Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", equation 33.
// sin2_n_h = |n × h|² = 1 − (n·h)²: from the cross product it keeps its digits where (n·h)² rounds to 1, which is where a
// smooth lobe lives. For alpha → 0 the value at the peak, 1/(π alpha²), stays finite down to kMinPerceptualRoughness.
float D_GGX(float n_dot_h, float sin2_n_h, float alpha) {
  float a = n_dot_h * alpha;
  float k = alpha / max(sin2_n_h + a * a, 1e-20);
  return k * k * kInversePi;
}

// Height-correlated Smith masking-shadowing over 4 (n·v)(n·l): Heitz 2014, "Understanding the Masking-Shadowing Function
// in Microfacet-Based BRDFs", equation 99, in the form of Lagarde & de Rousiers 2014, listing 2. Each side has a root of its own, so
// that the viewer's is taken once for all lights.
float smithRoot(float n_dot_x, float alpha2) { return sqrt(n_dot_x * n_dot_x * (1.0 - alpha2) + alpha2); }
float V_SmithGGXCorrelated(float n_dot_v, float n_dot_l, float root_v, float root_l) {
  return 0.5 / max(n_dot_l * root_v + n_dot_v * root_l, 1e-12);
}

// D_GGX · V_SmithGGXCorrelated with one division for both.
//
// `widening` is for light from a disc rather than a point: the square of half its angular radius, which is how far it spreads half
// vectors. The mean over a disc of radius ρ of D about its peak, α²/(π (θ² + α²)²), is 1/(π (α² + ρ²)): the peak of a lobe of
// α² + ρ², and like any D that one keeps the light's energy (in the spirit of Karis 2013, equation 10, which has to divide it out).
float DV_GGX(float n_dot_h2, float sin2_n_h, float n_dot_v, float n_dot_l, float alpha2, float root_v, float widening) {
  float wide2 = min(alpha2 + widening, 1.0);
  float spread = sin2_n_h + n_dot_h2 * wide2;
  float masking = n_dot_l * root_v + n_dot_v * smithRoot(n_dot_l, alpha2);
  return 0.5 * kInversePi * wide2 / max(spread * spread * masking, 1e-30);
}
float DV_GGX(float n_dot_h2, float sin2_n_h, float n_dot_v, float n_dot_l, float alpha2, float root_v) {
  return DV_GGX(n_dot_h2, sin2_n_h, n_dot_v, n_dot_l, alpha2, root_v, 0.0);
}

// The lobe of facets that lie on a bumpy surface whose slopes have this variance along each axis: α² is twice a Beckmann lobe's
// slope variance, and variances add (Olano & Baker 2010, "LEAN Mapping", section 3).
float widenedRoughness(float perceptual_roughness, float slope_variance) {
  float alpha2 = perceptual_roughness * perceptual_roughness * perceptual_roughness * perceptual_roughness;
  return sqrt(sqrt(min(alpha2 + 2.0 * slope_variance, 1.0)));
}

// Schlick's approximation of Smith's one-sided masking (Schlick 1994, equation 19), with the k of Karis 2013, "Real
// Shading in Unreal Engine 4", equation 4 and the text below it.
float G1_SchlickGGX(float n_dot_x, float k) { return n_dot_x / max(n_dot_x * (1.0 - k) + k, 1e-12); }
float G_SmithSchlickGGX(float n_dot_v, float n_dot_l, float k) {
  return G1_SchlickGGX(n_dot_v, k) * G1_SchlickGGX(n_dot_l, k);
}
float k_SchlickGGXLamp(float perceptual_roughness) {
  float r = perceptual_roughness + 1.0;
  return r * r / 8.0;
}
float k_SchlickGGXImage(float perceptual_roughness) { return perceptual_roughness * perceptual_roughness / 2.0; }

// What a single-scattering lobe loses to light that bounces between facets, given back in its own shape: Turquin 2019,
// "Practical multiple scattering compensation for microfacet models". dfg = (scale, bias) of the split sum
// (Karis 2013), so dfg.x + dfg.y is the albedo of the lobe where every facet is a perfect mirror.
vec3 energyCompensation(vec3 f0, vec2 dfg) { return vec3(1.0) + f0 * (1.0 / max(dfg.x + dfg.y, 1e-4) - 1.0); }

// The compensated lobe's directional albedo, (f0 x + y)(1 + f0 (1/E_ss − 1)) with dfg = (x, y) and E_ss = x + y, is a quadratic in f0 that is
// 1 at f0 = 1: y + f0 ((1 − y − g) + f0 g) with g = x (1/E_ss − 1). So (y, g) say it all, and may be mixed and averaged before
// f0 is known.
vec2 albedoTerms(vec2 dfg) { return vec2(dfg.y, dfg.x * (1.0 / max(dfg.x + dfg.y, 1e-4) - 1.0)); }
// `total` is the sum of the weights that the terms were mixed with.
vec3 albedoOfTerms(vec3 f0, vec2 terms, float total) { return terms.x + f0 * ((total - terms.x - terms.y) + f0 * terms.y); }

// Share of a uniform hemisphere's light that the compensated lobe sends towards the direction that dfg was read for.
vec3 E_GGX(vec3 f0, vec2 dfg) { return albedoOfTerms(f0, albedoTerms(dfg), 1.0); }

// Cosine averages of albedoTerms over the hemisphere, ∫ · 2μ dμ: fits to quadrature of the height-correlated lobe, within 2.5e-4 for
// perceptual roughness 0.02..1.
vec2 averageAlbedoTerms(float perceptual_roughness) {
  float r = perceptual_roughness;
  float bias = 0.047168 + r * (0.018574 + r * (-0.142169 + r * (-0.608597 + r * (2.002675 + r * (-1.970591 + r * 0.655811)))));
  float gain = -0.000215 + r * (0.011425 + r * (-0.175414 + r * (0.879277 + r * (2.224502 + r * (-3.791919 + r * 1.440949)))));
  return vec2(bias, gain);
}
vec3 E_GGX_average(vec3 f0, float perceptual_roughness) {
  return albedoOfTerms(f0, averageAlbedoTerms(perceptual_roughness), 1.0);
}

// Specular occlusion from ambient occlusion: Lagarde & de Rousiers 2014, "Moving Frostbite to PBR", listing 26. 1 where ao is 1.
float specularOcclusion(float n_dot_v, float ao, float alpha) {
  if (ao >= 1.0) return 1.0;
  return clamp(pow(n_dot_v + ao, exp2(-16.0 * alpha - 1.0)) - 1.0 + ao, 0.0, 1.0);
}

// Light that a normal map would fetch from below the surface is faded out: Russell 2015, "Horizon Occlusion for Normal
// Mapped Reflections". 1 where the reflection leaves the surface.
float horizonOcclusion(vec3 reflected, vec3 vertex_normal) {
  float above = clamp(1.0 + dot(reflected, vertex_normal), 0.0, 1.0);
  return above * above;
}

#endif
