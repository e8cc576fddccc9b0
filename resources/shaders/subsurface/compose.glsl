// What the pass writes: light that leaves the body, added to the picture, and kept before and after diffusion.
layout(binding = 28) uniform sampler2D u_exit;

layout(location = 0) out vec4 o_beauty;  // added to what is there
layout(location = 1) out vec4 o_diffuse;
layout(location = 2) out vec4 o_scattered;

// `entering` is the light that entered at this pixel, `leaving` what leaves here.
void compose(ivec2 pixel, vec3 entering, vec3 leaving, bool covered) {
  vec3 cost = texelFetch(u_exit, pixel, 0).rgb;
  o_beauty = vec4(leaving * cost, 0.0);
  o_diffuse = vec4(entering * cost, covered ? 1.0 : 0.0);
  o_scattered = vec4(leaving * cost, covered ? 1.0 : 0.0);
}
