// Shows an image of the frame that is not radiance, so that a person can read it.
#include "false_colour.glsl"

layout(binding = 0) uniform sampler2D u_image;

uniform int u_aov;
uniform vec2 u_range;    // the numbers at the ends of the ramp: ValueRange in renderer/colour/false_colour.h
uniform float u_weight;  // 1 / samples in the image
uniform vec2 u_scale;    // texels of the image a pixel of the target

// Numbers of Aov in renderer/renderer.h.
const int kThickness = 5;
const int kNormal = 6;
const int kOcclusion = 7;
const int kProfileId = 8;
const int kEnergy = 9;
const int kDepth = 10;

const vec3 kNotKnown = vec3(0.22);

layout(location = 0) out vec4 o_display;

// Well apart hues for small whole numbers.
vec3 idColour(float id) {
  return 0.55 + 0.45 * cos(6.2831853 * (id * 0.618034 + vec3(0.0, 0.33, 0.67)));
}

float shareOf(float value) { return (value - u_range.x) / max(u_range.y - u_range.x, 1e-6); }

void main() {
  vec4 sum = texelFetch(u_image, ivec2(gl_FragCoord.xy * u_scale), 0);
  vec3 colour = vec3(0.0);
  if (u_aov == kProfileId) {
    colour = sum.b > 0.5 ? idColour(sum.b) : vec3(0.0);
  } else if (u_aov == kEnergy) {
    float energy = sum.a * u_weight;
    // Half floats and the mean of many samples end a little beside 1; that is no gain.
    if (energy > 0.0) colour = energy > u_range.y + 0.002 ? kAboveRange : viridis(shareOf(energy));
  } else if (sum.a > 0.0) {
    vec4 mean = sum / sum.a;
    if (u_aov == kNormal) colour = normalize(mean.xyz) * 0.5 + 0.5;
    if (u_aov == kOcclusion) colour = mean.rrr;
    if (u_aov == kThickness) colour = mean.b < 0.0 ? kNotKnown : viridis(shareOf(mean.b));
    if (u_aov == kDepth) colour = vec3(1.0 - clamp(shareOf(mean.g), 0.0, 1.0));
  }
  o_display = vec4(colour, 1.0);
}
