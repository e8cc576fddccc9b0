// What the scene's lights send to a point.
//
// Intensities: point, spot, sphere and rect lights have a radiant intensity, so they give I/d² at distance d scene units; a
// directional light has its irradiance. In a still picture every sample takes another point of a sphere or rect light (LightPoint in
// renderer/lighting/light_point.h), which shines as a piece of a flat emitter with the one-sided cosine: a rect's intensity is the one on
// its axis. Where there is one picture only, a sphere is lit from its centre, which for a point that sees all of it is its exact
// irradiance (I = L π r²), and a rect from its own; highlights are as wide as the light either way.
#ifndef DERMIS_LIGHTS
#define DERMIS_LIGHTS

#include "frame_block.glsl"

// Kinds of light, in the order of LightType. A point light (0) is what is left when no other test is true.
const int kLightDirectional = 1;
const int kLightSpot = 2;
const int kLightSphere = 3;
const int kLightRect = 4;

struct LightSample {
  vec3 to_light;    // unit; shorter inside a sphere light
  vec3 irradiance;  // on a surface that faces the light
  float widening;   // of highlights, see DV_GGX
};

// 1 inside the inner cone, 0 outside the outer one; the square of the linear ramp between their cosines, as glTF's
// KHR_lights_punctual defines it, so that an exported light looks the same.
float spotFalloff(float cos_angle, float cos_inner, float cos_outer) {
  float t = clamp((cos_angle - cos_outer) / max(cos_inner - cos_outer, 1e-4), 0.0, 1.0);
  return t * t;
}

// Does DO(number) for each lamp. Software GL runs a loop's body once more when all pixels have left it at its top, so it asks at its end;
// and both sides of every branch, so where there is no lamp it gets DERMIS_NO_LAMPS.
#ifdef DERMIS_NO_LAMPS
#define EACH_LIGHT(DO)
#else
#define EACH_LIGHT(DO)                                    \
  if (u_light_count.x > 0) {                              \
    int number = 0;                                       \
    do { DO(number) } while (++number < u_light_count.x); \
  }
#endif

LightSample lightAt(int index, vec3 position) {
  LightData light = u_lights[index];
  int type = int(light.position_type.w);
  LightSample result;
  if (type == kLightDirectional) {
    result.to_light = -light.direction_outer.xyz;
    result.irradiance = light.radiant_inner.rgb;
    result.widening = 0.0;
    return result;
  }
  vec3 offset = light.position_type.xyz - position;
  // A light inside the surface would be infinitely bright; a sphere light is never nearer than its own surface.
  float nearest = type == kLightSphere ? light.size.x * light.size.x : 0.0;
  float inverse_distance = inversesqrt(max(dot(offset, offset), max(nearest, 1e-8)));
  result.to_light = offset * inverse_distance;
  result.irradiance = light.radiant_inner.rgb * (inverse_distance * inverse_distance);
  float half_angle = 0.5 * light.size.w * inverse_distance;
  result.widening = half_angle * half_angle;
  float cos_angle = -dot(result.to_light, light.direction_outer.xyz);
  if (type == kLightSpot) result.irradiance *= spotFalloff(cos_angle, light.radiant_inner.w, light.direction_outer.w);
  if (type == kLightRect) result.irradiance *= max(cos_angle, 0.0);
  return result;
}

#endif
