// Moves a piece's vertex along the surface's direction by the height that the map has there. Nothing tears: on a shared edge both
// sides compute the same sums of two terms (`precise` keeps a compiler from fusing one of them), at the same coordinates of the map.
#define DERMIS_NO_DERIVATIVES  // only fragments have neighbours
#include "displace_view.glsl"
#include "displacement_height.glsl"

layout(triangles, equal_spacing, ccw) in;

in vec3 c_position[];
in vec3 c_normal[];
in vec4 c_tangent[];
in vec2 c_uv[];
in vec4 c_sky[];
in vec4 c_far[];
in vec3 c_bounce[];
in vec4 c_direction[];
in vec3 c_gradient_u[];
in vec3 c_gradient_v[];
patch in vec2 c_corner_uv[3];
patch in vec4 c_edge_uv[3];

out vec3 v_position;
out vec3 v_normal;
out vec4 v_tangent;
out vec2 v_uv;
out vec4 v_sky;
out vec4 v_far;
out vec3 v_bounce;
out vec3 v_gradient_u;
out vec3 v_gradient_v;
out float v_curvature;

// Where the map is read for the height at this vertex.
vec2 heightUv(vec3 b, vec2 inside) {
  if (b.x == 1.0) return c_corner_uv[0];
  if (b.y == 1.0) return c_corner_uv[1];
  if (b.z == 1.0) return c_corner_uv[2];
  precise vec2 uv = inside;
  if (b.x == 0.0) uv = c_edge_uv[0].xy * b.y + c_edge_uv[0].zw * b.z;
  if (b.y == 0.0) uv = c_edge_uv[1].xy * b.z + c_edge_uv[1].zw * b.x;
  if (b.z == 0.0) uv = c_edge_uv[2].xy * b.x + c_edge_uv[2].zw * b.y;
  return uv;
}

void main() {
  vec3 b = gl_TessCoord;
  precise vec3 position = c_position[0] * b.x + c_position[1] * b.y + c_position[2] * b.z;
  precise vec4 direction = c_direction[0] * b.x + c_direction[1] * b.y + c_direction[2] * b.z;
  v_uv = c_uv[0] * b.x + c_uv[1] * b.y + c_uv[2] * b.z;
  // A level of the map whose texels are half as far apart as the vertices. It depends on the place alone, as it must on a shared edge.
  float apart = clamp(u_displace_detail.z * displaceDistance(position), u_displace_texels.x, u_displace_texels.y);
  float lod = log2(max(0.5 * apart, 1.0));
  precise vec3 displaced =
      position + direction.xyz * (heightLod(heightUv(b, v_uv), lod) / max(length(direction.xyz), 1e-3));
  v_position = displaced;
  v_normal = c_normal[0] * b.x + c_normal[1] * b.y + c_normal[2] * b.z;
  v_tangent = vec4(c_tangent[0].xyz * b.x + c_tangent[1].xyz * b.y + c_tangent[2].xyz * b.z, c_tangent[0].w);
  v_sky = c_sky[0] * b.x + c_sky[1] * b.y + c_sky[2] * b.z;
  v_far = c_far[0] * b.x + c_far[1] * b.y + c_far[2] * b.z;
  v_bounce = c_bounce[0] * b.x + c_bounce[1] * b.y + c_bounce[2] * b.z;
  v_gradient_u = c_gradient_u[0] * b.x + c_gradient_u[1] * b.y + c_gradient_u[2] * b.z;
  v_gradient_v = c_gradient_v[0] * b.x + c_gradient_v[1] * b.y + c_gradient_v[2] * b.z;
  v_curvature = direction.w;
  gl_Position = u_displace_clip * vec4(displaced, 1.0);
}
