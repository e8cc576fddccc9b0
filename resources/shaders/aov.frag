// Shows an image of the frame that is not radiance, so that a person can read it.
layout(binding = 0) uniform sampler2D u_image;

uniform int u_aov;
uniform vec2 u_range;  // of depth, scene units
uniform float u_weight;  // 1 / samples in the image
uniform vec2 u_scale;  // texels of the image a pixel of the target

// Numbers of Aov in renderer/renderer.h.
const int kThickness = 5;
const int kNormal = 6;
const int kOcclusion = 7;
const int kProfileId = 8;
const int kEnergy = 9;
const int kDepth = 10;

const float kThickestMm = 20.0;

layout(location = 0) out vec4 o_display;

// Well apart hues for small whole numbers.
vec3 idColour(float id) {
  return 0.55 + 0.45 * cos(6.2831853 * (id * 0.618034 + vec3(0.0, 0.33, 0.67)));
}

void main() {
  vec4 sum = texelFetch(u_image, ivec2(gl_FragCoord.xy * u_scale), 0);
  vec3 colour = vec3(0.0);
  if (u_aov == kProfileId) {
    colour = sum.b > 0.5 ? idColour(sum.b) : vec3(0.0);
  } else if (u_aov == kEnergy) {
    colour = vec3(sum.a * u_weight);
  } else if (sum.a > 0.0) {
    vec4 mean = sum / sum.a;
    if (u_aov == kNormal) colour = normalize(mean.xyz) * 0.5 + 0.5;
    if (u_aov == kOcclusion) colour = mean.rrr;
    if (u_aov == kThickness) colour = vec3(clamp(mean.b / kThickestMm, 0.0, 1.0));
    if (u_aov == kDepth) colour = vec3(1.0 - clamp((mean.g - u_range.x) / max(u_range.y - u_range.x, 1e-6), 0.0, 1.0));
  }
  o_display = vec4(colour, 1.0);
}
