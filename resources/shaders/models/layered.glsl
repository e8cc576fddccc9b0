// A specular layer over a body that scatters: the lighting that skin, eye, lens and metallic_roughness share.
//
// The layer is one GGX lobe, or two with DERMIS_LOBES 2 (set before including this), with height-correlated Smith visibility, Schlick
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
#include "lighting/lobe_sampling.glsl"
#include "lights.glsl"
#include "shadows.glsl"
#include "surface_types.glsl"

#ifndef DERMIS_LOBES
#define DERMIS_LOBES 1
#endif

struct Lobe {
  float perceptual_roughness;
  float weight;  // share of the lobe times the layer's intensity
};

// The share `metallic` of the surface is metal without a body, the rest a dielectric over one, as glTF mixes them.
// The lobes are members and not an array: Mesa's software GL keeps what is indexed in a loop in memory, at twice the cost of the frame.
struct Layer {
  vec3 body_f0;   // of the facets over the body
  vec3 metal_f0;  // of metallic ones
  float metallic;
  Lobe first;
#if DERMIS_LOBES == 2
  Lobe second;
#endif
};

// What is the same for all lights, of a lobe.
struct LobePoint {
  // Fresnel reflectance with weight and compensation, at_normal + at_grazing (1 − v·h)⁵: Schlick's, of body and metal.
  vec3 at_normal;
  vec3 at_grazing;
  vec3 reflectance;  // towards the viewer, of light from all around
  float alpha2;
  float root_v;
};

// And of a lit point.
struct LayerPoint {
  vec3 normal;
  vec3 view;
  float n_dot_v;
  LobePoint first;
#if DERMIS_LOBES == 2
  LobePoint second;
#endif
  vec3 body_out;     // (1 − metallic) (1 − E(μ_out))
  vec3 body_in;      // 1 / (1 − ⟨E⟩)
  vec3 reflectance;  // of the layer, towards the viewer, of light from all around
};

struct LayerLight {
  vec3 body;  // light that enters the body, as irradiance/π: times albedo and body_out it is radiance
  vec3 specular;
};

// The share of a light at cosine μ that reaches the body.
vec3 bodyTransmittance(Layer layer, float mu) {
  vec2 terms = layer.first.weight * albedoTerms(dfgSmith(mu, layer.first.perceptual_roughness));
  float total = layer.first.weight;
#if DERMIS_LOBES == 2
  terms += layer.second.weight * albedoTerms(dfgSmith(mu, layer.second.perceptual_roughness));
  total += layer.second.weight;
#endif
  return vec3(1.0) - min(albedoOfTerms(layer.body_f0, terms, total), 1.0);
}

LobePoint lobePoint(Layer layer, Lobe lobe, float n_dot_v, vec2 dfg) {
  LobePoint p;
  vec3 body = lobe.weight * (1.0 - layer.metallic) * energyCompensation(layer.body_f0, dfg);
  vec3 metal = lobe.weight * layer.metallic * energyCompensation(layer.metal_f0, dfg);
  p.at_normal = body * layer.body_f0 + metal * layer.metal_f0;
  p.at_grazing = body + metal - p.at_normal;
  p.reflectance = p.at_normal * dfg.x + (body + metal) * dfg.y;
  float alpha = lobe.perceptual_roughness * lobe.perceptual_roughness;
  p.alpha2 = alpha * alpha;
  p.root_v = smithRoot(n_dot_v, p.alpha2);
  return p;
}

LayerPoint layerPoint(Layer layer, vec3 normal, vec3 view) {
  LayerPoint p;
  p.normal = normal;
  p.view = view;
  p.n_dot_v = clamp(dot(normal, view), kMinNdotV, 1.0);
  vec2 dfg = dfgSmith(p.n_dot_v, layer.first.perceptual_roughness);
  p.first = lobePoint(layer, layer.first, p.n_dot_v, dfg);
  vec2 terms = layer.first.weight * albedoTerms(dfg);
  vec2 average = layer.first.weight * averageAlbedoTerms(layer.first.perceptual_roughness);
  float total = layer.first.weight;
#if DERMIS_LOBES == 2
  dfg = dfgSmith(p.n_dot_v, layer.second.perceptual_roughness);
  p.second = lobePoint(layer, layer.second, p.n_dot_v, dfg);
  terms += layer.second.weight * albedoTerms(dfg);
  average += layer.second.weight * averageAlbedoTerms(layer.second.perceptual_roughness);
  total += layer.second.weight;
#endif
  p.body_out = (1.0 - layer.metallic) * (vec3(1.0) - min(albedoOfTerms(layer.body_f0, terms, total), 1.0));
  // Where the layer reflects everything, body_out is 0 as well.
  p.body_in = vec3(1.0) / max(vec3(1.0) - albedoOfTerms(layer.body_f0, average, total), 1e-3);
  p.reflectance = p.first.reflectance;
#if DERMIS_LOBES == 2
  p.reflectance += p.second.reflectance;
#endif
  return p;
}

// The lobes' BRDF value for one light, without the cosine.
vec3 layerSpecular(LayerPoint p, vec3 to_light, float n_dot_l, float widening) {
  vec3 h = normalize(to_light + p.view);
  float n_dot_h2 = dot(p.normal, h) * dot(p.normal, h);
  vec3 n_cross_h = cross(p.normal, h);
  float sin2_n_h = dot(n_cross_h, n_cross_h);
  float grazing = pow5(1.0 - clamp(dot(p.view, h), 0.0, 1.0));
  vec3 sum = DV_GGX(n_dot_h2, sin2_n_h, p.n_dot_v, n_dot_l, p.first.alpha2, p.first.root_v, widening) *
             (p.first.at_normal + p.first.at_grazing * grazing);
#if DERMIS_LOBES == 2
  sum += DV_GGX(n_dot_h2, sin2_n_h, p.n_dot_v, n_dot_l, p.second.alpha2, p.second.root_v, widening) *
         (p.second.at_normal + p.second.at_grazing * grazing);
#endif
  return sum;
}

void addLamp(int number, Layer layer, LayerPoint p, vec3 position, vec3 vertex_normal, inout LayerLight sum) {
  LightSample light = lightAt(number, position);
  float n_dot_l = clamp(dot(p.normal, light.to_light), 0.0, 1.0);
  if (n_dot_l > 0.0) {
    vec3 received = light.irradiance * (n_dot_l * shadowAt(number, position, vertex_normal));
    sum.specular += received * layerSpecular(p, light.to_light, n_dot_l, light.widening);
    sum.body += received * bodyTransmittance(layer, n_dot_l);
  }
}

// All lamps. `vertex_normal` is that of the side that is seen: shadows know the mesh, not its normal map.
LayerLight layerLamps(Layer layer, LayerPoint p, vec3 position, vec3 vertex_normal) {
  LayerLight sum = LayerLight(vec3(0.0), vec3(0.0));
#define ADD_LAMP(number) addLamp(number, layer, p, position, vertex_normal, sum);
  EACH_LIGHT(ADD_LAMP)
#undef ADD_LAMP
  sum.body *= kInversePi * p.body_in;
  return sum;
}

// Split sum (Karis 2013), one prefiltered look-up; corrected by sampling where the picture is an average (lobe_sampling.glsl).
vec3 lobeImage(Lobe lobe, LobePoint point, LayerPoint p, vec3 reflected, float ao, float horizon, vec3 in_the_way, vec2 shift) {
  float alpha = lobe.perceptual_roughness * lobe.perceptual_roughness;
  vec3 mean = environmentPrefiltered(reflected, lobe.perceptual_roughness);
  vec3 sum = point.reflectance * mean;
  for (int i = 0; i < lobeSamples(); ++i)
    sum += lobeCorrection(p.normal, p.view, p.n_dot_v, lobe.perceptual_roughness, point.at_normal, point.at_grazing, point.root_v,
                          mean, lobeRandom(shift));
  float open = specularOcclusion(p.n_dot_v, ao, alpha);
  return open * horizon * sum + (1.0 - open) * point.reflectance * in_the_way;
}

// Image light. Reflections are dimmed as far as they come from where something is in the way, and show that instead: the rest of the mesh,
// by the mean of what it sends here.
LayerLight layerImage(Layer layer, LayerPoint p, vec3 vertex_normal, SkyLight sky) {
  vec3 r = reflect(-p.view, p.normal);
  float horizon = horizonOcclusion(r, vertex_normal);
  vec3 in_the_way = sky.bounce / max(1.0 - sky.open, 0.02);
  vec3 specular = lobeImage(layer.first, p.first, p, r, sky.open, horizon, in_the_way, vec2(0.5));
#if DERMIS_LOBES == 2
  specular += lobeImage(layer.second, p.second, p, r, sky.open, horizon, in_the_way, vec2(0.0, 0.25));
#endif
  return LayerLight(environmentIrradiance(p.normal) * sky.share + sky.bounce, specular);
}

// Share of a white environment that layer and body send to the viewer, of the channel that sends most.
float layerEnergy(LayerPoint p, vec3 albedo, float cavity) {
  vec3 sent = p.body_out * albedo + p.reflectance * cavity;
  return max(sent.r, max(sent.g, sent.b));
}

vec3 inHalfRange(vec3 radiance) { return min(radiance, vec3(kRadianceMax)); }

#endif
