// Geometry to the screen. Model transforms were applied when the file was read, so model space is world space.
#include "frame_block.glsl"

layout(location = 0) in vec4 a_position_u;
layout(location = 1) in vec4 a_normal_v;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec4 a_sky;  // VertexLight of vertex_light.comp
layout(location = 4) in vec4 a_far;
layout(location = 5) in vec4 a_bounce;
#ifdef DERMIS_DISPLACED
layout(location = 8) in vec4 a_direction;  // DisplacementFrame
layout(location = 9) in vec3 a_gradient_u;
layout(location = 10) in vec3 a_gradient_v;
#endif

out vec3 v_position;
out vec3 v_normal;
out vec4 v_tangent;
out vec2 v_uv;
out vec4 v_sky;  // share of the environment's irradiance that arrives; ambient occlusion
out vec4 v_far;  // irradiance/π of the far side; thickness in mm
out vec3 v_bounce;  // irradiance/π from other parts of the mesh
#ifdef DERMIS_DISPLACED
out vec4 v_direction;  // to displace.tesc
out vec3 v_gradient_u;
out vec3 v_gradient_v;
#endif

void main() {
  v_position = a_position_u.xyz;
  v_normal = a_normal_v.xyz;
  v_tangent = a_tangent;
  v_uv = vec2(a_position_u.w, a_normal_v.w);
  v_sky = a_sky;
  v_far = a_far;
  v_bounce = a_bounce.rgb;
#ifdef DERMIS_DISPLACED
  v_direction = a_direction;
  v_gradient_u = a_gradient_u;
  v_gradient_v = a_gradient_v;
#endif
  gl_Position = u_view_projection * vec4(a_position_u.xyz, 1.0);
}
