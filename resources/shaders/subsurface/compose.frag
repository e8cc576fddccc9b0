// The body's light: what entered, times what leaving costs.
layout(binding = 0) uniform sampler2D u_entering;
layout(binding = 1) uniform sampler2D u_exit;
layout(binding = 2) uniform sampler2D u_depth;  // reversed: 0 where nothing is

layout(location = 0) out vec4 o_beauty;  // added to what is there
layout(location = 1) out vec4 o_diffuse;
layout(location = 2) out vec4 o_scattered;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 left = texelFetch(u_entering, pixel, 0).rgb * texelFetch(u_exit, pixel, 0).rgb;
  o_beauty = vec4(left, 0.0);
  float covered = texelFetch(u_depth, pixel, 0).r > 0.0 ? 1.0 : 0.0;
  o_diffuse = vec4(left, covered);
  o_scattered = o_diffuse;
}
