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

// The share `metallic` of the surface is metal without a body, the rest a dielectric over one, as glTF mixes them.
struct Layer {
  vec3 body_f0;   // of the facets over the body
  vec3 metal_f0;  // of metallic ones
  float metallic;
  float perceptual_roughness[DERMIS_LOBES];
  float weight[DERMIS_LOBES];  // share of the lobe times the layer's intensity
};

// A lit point: what is the same for all lights.
struct LayerPoint {
  vec3 normal;
  vec3 view;
  float n_dot_v;
  // A lobe's Fresnel reflectance with its weight and compensation, at_normal + at_grazing (1 − v·h)⁵: Schlick's, of body and metal.
  vec3 at_normal[DERMIS_LOBES];
  vec3 at_grazing[DERMIS_LOBES];
  float alpha2[DERMIS_LOBES];
  float root_v[DERMIS_LOBES];
  vec3 reflectance[DERMIS_LOBES];  // towards the viewer, of light from all around
  vec3 body_out;                   // (1 − metallic) (1 − E(μ_out))
  vec3 body_norm;                  // body_out / (1 − ⟨E⟩)
};

struct LayerLight {
  vec3 body;  // light that the body receives and lets out again, as irradiance/π: times albedo it is radiance
  vec3 specular;
};

// The share of a light at cosine μ that reaches the body.
vec3 bodyTransmittance(Layer layer, float mu) {
  vec2 terms = vec2(0.0);
  float total = 0.0;
  for (int i = 0; i < DERMIS_LOBES; ++i) {
    terms += layer.weight[i] * albedoTerms(dfgSmith(mu, layer.perceptual_roughness[i]));
    total += layer.weight[i];
  }
  return vec3(1.0) - min(albedoOfTerms(layer.body_f0, terms, total), 1.0);
}

LayerPoint layerPoint(Layer layer, vec3 normal, vec3 view) {
  LayerPoint p;
  p.normal = normal;
  p.view = view;
  p.n_dot_v = clamp(dot(normal, view), kMinNdotV, 1.0);
  vec2 terms = vec2(0.0);
  vec2 average = vec2(0.0);
  float total = 0.0;
  for (int i = 0; i < DERMIS_LOBES; ++i) {
    float roughness = layer.perceptual_roughness[i];
    vec2 dfg = dfgSmith(p.n_dot_v, roughness);
    vec3 body = layer.weight[i] * (1.0 - layer.metallic) * energyCompensation(layer.body_f0, dfg);
    vec3 metal = layer.weight[i] * layer.metallic * energyCompensation(layer.metal_f0, dfg);
    p.at_normal[i] = body * layer.body_f0 + metal * layer.metal_f0;
    p.at_grazing[i] = body + metal - p.at_normal[i];
    p.reflectance[i] = p.at_normal[i] * dfg.x + (body + metal) * dfg.y;
    p.alpha2[i] = roughness * roughness * roughness * roughness;
    p.root_v[i] = smithRoot(p.n_dot_v, p.alpha2[i]);
    terms += layer.weight[i] * albedoTerms(dfg);
    average += layer.weight[i] * averageAlbedoTerms(roughness);
    total += layer.weight[i];
  }
  p.body_out = (1.0 - layer.metallic) * (vec3(1.0) - min(albedoOfTerms(layer.body_f0, terms, total), 1.0));
  // Where the layer reflects everything, body_out is 0 as well.
  p.body_norm = p.body_out / max(vec3(1.0) - albedoOfTerms(layer.body_f0, average, total), 1e-3);
  return p;
}

// The lobes' BRDF value for one light, without the cosine.
vec3 layerSpecular(LayerPoint p, vec3 to_light, float n_dot_l) {
  vec3 h = normalize(to_light + p.view);
  float n_dot_h = dot(p.normal, h);
  vec3 n_cross_h = cross(p.normal, h);
  float sin2_n_h = dot(n_cross_h, n_cross_h);
  float grazing = pow5(1.0 - clamp(dot(p.view, h), 0.0, 1.0));
  vec3 sum = vec3(0.0);
  for (int i = 0; i < DERMIS_LOBES; ++i)
    sum += DV_GGX(n_dot_h * n_dot_h, sin2_n_h, p.n_dot_v, n_dot_l, p.alpha2[i], p.root_v[i]) *
           (p.at_normal[i] + p.at_grazing[i] * grazing);
  return sum;
}

// All lamps.
LayerLight layerLamps(Layer layer, LayerPoint p, vec3 position) {
  LayerLight sum = LayerLight(vec3(0.0), vec3(0.0));
  for (int i = 0; i < u_light_count.x; ++i) {
    LightSample light = lightAt(i, position);
    float n_dot_l = clamp(dot(p.normal, light.to_light), 0.0, 1.0);
    if (n_dot_l <= 0.0) continue;
    vec3 received = light.irradiance * n_dot_l;
    sum.specular += received * layerSpecular(p, light.to_light, n_dot_l);
    sum.body += received * bodyTransmittance(layer, n_dot_l);
  }
  sum.body *= kInversePi * p.body_norm;
  return sum;
}

// The environment: split sum (Karis 2013), one prefiltered look-up a lobe. `ao` dims the body's light, and the reflections as far as
// they come from where it says that something is in the way.
LayerLight layerImage(Layer layer, LayerPoint p, vec3 vertex_normal, float ao) {
  vec3 r = reflect(-p.view, p.normal);
  vec3 specular = vec3(0.0);
  for (int i = 0; i < DERMIS_LOBES; ++i) {
    float roughness = layer.perceptual_roughness[i];
    specular += specularOcclusion(p.n_dot_v, ao, roughness * roughness) * p.reflectance[i] *
                environmentPrefiltered(r, roughness);
  }
  return LayerLight(environmentIrradiance(p.normal) * ao * p.body_out, specular * horizonOcclusion(r, vertex_normal));
}

vec3 inHalfRange(vec3 radiance) { return min(radiance, vec3(kRadianceMax)); }

#endif
