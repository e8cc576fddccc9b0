// The body's light without diffusion: all leaves where it entered.
#include "subsurface/compose.glsl"

layout(binding = 21) uniform sampler2D u_entering;
layout(binding = 23) uniform sampler2D u_depth;  // reversed: 0 where nothing is

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 entering = texelFetch(u_entering, pixel, 0).rgb;
  compose(pixel, entering, entering, texelFetch(u_depth, pixel, 0).r > 0.0);
}
