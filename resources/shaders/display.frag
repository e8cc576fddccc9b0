// From scene-linear radiance to the display: mean of the samples, exposure, view transform, dither. The only place that
// encodes for a display.
#include "generated/display.glsl"
#ifdef DERMIS_EXACT
vec3 encode(vec3 scene) { return displayExact(vec4(scene, 1.0)).rgb; }
#else
vec3 encode(vec3 scene) { return displayBaked(scene); }
#endif

layout(binding = 0) uniform sampler2D u_image;

uniform float u_weight;     // 1 / samples
uniform float u_exposure;   // 2^stops
uniform float u_dither;     // 1/255 for an 8-bit display, 0 for none
uniform int u_alpha_mode;   // see below

const int kAlphaPremultiply = 0;  // onto a window: encoded colour over black
const int kAlphaStraight = 1;     // into a file: unassociated

layout(location = 0) out vec4 o_display;

// Interleaved gradient noise, 0..1: Jimenez 2014, "Next Generation Post Processing in Call of Duty".
float gradientNoise(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))); }

vec4 sceneAt(vec2 pixel) { return texelFetch(u_image, ivec2(pixel), 0) * u_weight; }

// The encoded colour of one scene-linear value.
vec4 displayed(vec4 scene) {
  float alpha = clamp(scene.a, 0.0, 1.0);
  vec3 straight = alpha > 0.0 ? scene.rgb / alpha : scene.rgb;
  return vec4(encode(straight * u_exposure), alpha);
}

#ifdef DERMIS_EDGE_FILTER
#include "edge_filter.glsl"
#endif

void main() {
#ifdef DERMIS_EDGE_FILTER
  vec4 result = edgeFiltered(gl_FragCoord.xy);
#else
  vec4 result = displayed(sceneAt(gl_FragCoord.xy));
#endif
  result.rgb += (gradientNoise(gl_FragCoord.xy) - 0.5) * u_dither;
  o_display = u_alpha_mode == kAlphaStraight ? result : vec4(result.rgb * result.a, result.a);
}
