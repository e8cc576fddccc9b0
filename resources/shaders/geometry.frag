// Only what the surface is, for shading afterwards: software GL shades whole blocks of pixels for each small triangle, so a dense mesh
// costs several times its pixels unless the expensive part runs once a pixel.
#include "octahedron.glsl"

uniform int u_slot;

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;
in vec4 v_sky;
in vec4 v_far;
in vec3 v_bounce;
#ifdef DERMIS_DISPLACED
#include "displacement.glsl"
in vec3 v_gradient_u;
in vec3 v_gradient_v;
in float v_curvature;
#endif

layout(location = 0) out vec4 o_surface;  // uv, normal on the octahedron
layout(location = 1) out vec4 o_tangent;  // tangent; (slot + 1) · 4 + 2 if front-facing + 1 if the tangent's sign is positive
layout(location = 2) out vec4 o_sky;  // as surface.vert leaves them
layout(location = 3) out vec4 o_far;
layout(location = 4) out vec4 o_bounce;
#ifdef DERMIS_GRADIENTS
layout(location = 5) out vec4 o_gradients;  // of uv, along x and y of the screen
#endif

void main() {
  vec3 normal = v_normal;
#ifdef DERMIS_DISPLACED
  normal = displacedNormal(normalize(normal), v_uv, v_gradient_u, v_gradient_v, v_curvature);
#endif
  o_surface = vec4(v_uv, toOctahedron(normal));
  o_tangent = vec4(v_tangent.xyz, float((u_slot + 1) * 4 + (gl_FrontFacing ? 2 : 0) + (v_tangent.w > 0.0 ? 1 : 0)));
  o_sky = v_sky;
  o_far = v_far;
  o_bounce = vec4(v_bounce, 0.0);
#ifdef DERMIS_GRADIENTS
  o_gradients = vec4(dFdx(v_uv), dFdy(v_uv));
#endif
}
