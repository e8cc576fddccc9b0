// Shows an image of the frame that is not radiance, so that a person can read it.
layout(binding = 0) uniform sampler2D u_image;

uniform int u_kind;
uniform vec2 u_range;  // of depth, scene units
uniform vec2 u_scale;  // texels of the image a pixel of the target

const int kNormal = 0;
const int kOcclusion = 1;
const int kDepth = 2;
const int kProfileId = 3;

layout(location = 0) out vec4 o_display;

// Well apart hues for small whole numbers.
vec3 idColour(float id) {
  return 0.55 + 0.45 * cos(6.2831853 * (id * 0.618034 + vec3(0.0, 0.33, 0.67)));
}

void main() {
  vec4 sum = texelFetch(u_image, ivec2(gl_FragCoord.xy * u_scale), 0);
  vec3 colour = vec3(0.0);
  if (u_kind == kProfileId) {
    colour = sum.r > 0.5 ? idColour(sum.r) : vec3(0.0);
  } else if (sum.a > 0.0) {
    vec4 mean = sum / sum.a;
    if (u_kind == kNormal) colour = normalize(mean.xyz) * 0.5 + 0.5;
    if (u_kind == kOcclusion) colour = mean.rrr;
    if (u_kind == kDepth) colour = vec3(1.0 - clamp((mean.g - u_range.x) / max(u_range.y - u_range.x, 1e-6), 0.0, 1.0));
  }
  o_display = vec4(colour, 1.0);
}
