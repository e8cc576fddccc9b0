// A specular layer over a body that scatters: the lighting that skin, eye, lens and metallic_roughness share.
//
// The layer is one or two GGX lobes (DERMIS_LOBES, set before including this) with height-correlated Smith visibility, Schlick
// Fresnel and multiple-scattering compensation. Light that the layer reflects does not reach the body, the rest does: with E the
// layer's directional albedo and ⟨E⟩ its cosine average, a lamp's diffuse light is weighed by
// (1 − E(μ_in)) (1 − E(μ_out)) / (1 − ⟨E⟩), image light by 1 − E(μ_out), whose incoming factor averages to 1 (Kelemen & Szirmay-Kalos
// 2001, "A Microfacet Based Coupled Specular-Matte BRDF Model"). A white body under any layer is white in a white world.
#ifndef DERMIS_LAYERED
#define DERMIS_LAYERED

#include "brdf.glsl"
#include "frame_block.glsl"
#include "lighting/dfg.glsl"
#include "lighting/environment.glsl"
#include "lights.glsl"
#include "surface_types.glsl"

#ifndef DERMIS_LOBES
#define DERMIS_LOBES 1
#endif

struct Layer {
  vec3 f0;       // of the facets
  vec3 body_f0;  // of those over the body: a metal has no body, so its F0 takes nothing from the diffuse light
  float perceptual_roughness[DERMIS_LOBES];
  float weight[DERMIS_LOBES];  // share of the lobe times the layer's intensity
};

// A lit point: what is the same for all lights.
struct LayerPoint {
  vec3 normal;
  vec3 view;
  float n_dot_v;
  vec2 dfg[DERMIS_LOBES];
  vec3 compensation[DERMIS_LOBES];
  vec3 body_out;   // 1 − E(μ_out)
  vec3 body_norm;  // (1 − E(μ_out)) / (1 − ⟨E⟩)
};

struct LayerLight {
  vec3 body;  // light that the body receives and lets out again, as irradiance/π: times albedo it is radiance
  vec3 specular;
};

// The share of light from (or to) a direction at cosine μ that reaches (or leaves) the body.
vec3 bodyTransmittance(Layer layer, float mu) {
  vec3 reflected = vec3(0.0);
  for (int i = 0; i < DERMIS_LOBES; ++i)
    reflected += layer.weight[i] * E_GGX(layer.body_f0, dfgSmith(mu, layer.perceptual_roughness[i]));
  return vec3(1.0) - min(reflected, 1.0);
}

LayerPoint layerPoint(Layer layer, vec3 normal, vec3 view) {
  LayerPoint p;
  p.normal = normal;
  p.view = view;
  p.n_dot_v = clamp(dot(normal, view), kMinNdotV, 1.0);
  vec3 reflected = vec3(0.0);
  vec3 average = vec3(0.0);
  for (int i = 0; i < DERMIS_LOBES; ++i) {
    p.dfg[i] = dfgSmith(p.n_dot_v, layer.perceptual_roughness[i]);
    p.compensation[i] = energyCompensation(layer.f0, p.dfg[i]);
    reflected += layer.weight[i] * E_GGX(layer.body_f0, p.dfg[i]);
    average += layer.weight[i] * E_GGX_average(layer.body_f0, layer.perceptual_roughness[i]);
  }
  p.body_out = vec3(1.0) - min(reflected, 1.0);
  // Where the layer reflects everything, body_out is 0 as well.
  p.body_norm = p.body_out / max(vec3(1.0) - average, 1e-3);
  return p;
}

// The lobes' BRDF value for one light, without the cosine.
vec3 layerSpecular(Layer layer, LayerPoint p, vec3 to_light, float n_dot_l) {
  vec3 h = normalize(to_light + p.view);
  float n_dot_h = clamp(dot(p.normal, h), 0.0, 1.0);
  vec3 n_cross_h = cross(p.normal, h);
  float sin2_n_h = dot(n_cross_h, n_cross_h);
  vec3 lobes = vec3(0.0);
  for (int i = 0; i < DERMIS_LOBES; ++i) {
    float alpha = layer.perceptual_roughness[i] * layer.perceptual_roughness[i];
    lobes += layer.weight[i] * D_GGX(n_dot_h, sin2_n_h, alpha) * V_SmithGGXCorrelated(p.n_dot_v, n_dot_l, alpha) *
             p.compensation[i];
  }
  return lobes * F_Schlick(layer.f0, clamp(dot(p.view, h), 0.0, 1.0));
}

// All lamps.
LayerLight layerLamps(Layer layer, LayerPoint p, vec3 position) {
  LayerLight sum = LayerLight(vec3(0.0), vec3(0.0));
  for (int i = 0; i < u_light_count.x; ++i) {
    LightSample light = lightAt(i, position);
    float n_dot_l = clamp(dot(p.normal, light.to_light), 0.0, 1.0);
    if (n_dot_l <= 0.0) continue;
    vec3 received = light.irradiance * n_dot_l;
    sum.specular += received * layerSpecular(layer, p, light.to_light, n_dot_l);
    sum.body += received * kInversePi * bodyTransmittance(layer, n_dot_l) * p.body_norm;
  }
  return sum;
}

// The environment: split sum (Karis 2013), one prefiltered look-up a lobe. `ao` dims the body's light, and the reflections as far as
// they come from where it says that something is in the way.
LayerLight layerImage(Layer layer, LayerPoint p, vec3 vertex_normal, float ao) {
  vec3 r = reflect(-p.view, p.normal);
  vec3 specular = vec3(0.0);
  for (int i = 0; i < DERMIS_LOBES; ++i) {
    float roughness = layer.perceptual_roughness[i];
    vec3 reflectance = (layer.f0 * p.dfg[i].x + p.dfg[i].y) * p.compensation[i];
    specular += layer.weight[i] * specularOcclusion(p.n_dot_v, ao, roughness * roughness) * reflectance *
                environmentPrefiltered(r, roughness);
  }
  return LayerLight(environmentIrradiance(p.normal) * ao * p.body_out,
                    specular * horizonOcclusion(r, vertex_normal));
}

vec3 inHalfRange(vec3 radiance) { return min(radiance, vec3(kRadianceMax)); }

#endif
