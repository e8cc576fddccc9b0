// Divides a triangle as finely as the screen shows it. An edge's factor depends on the edge alone, so that both triangles at it agree.
#include "displace_view.glsl"

layout(vertices = 3) out;

in vec3 v_position[];
in vec3 v_normal[];
in vec4 v_tangent[];
in vec2 v_uv[];
in vec4 v_sky[];
in vec4 v_far[];
in vec3 v_bounce[];
in vec4 v_direction[];
in vec3 v_gradient_u[];
in vec3 v_gradient_v[];

out vec3 c_position[];
out vec3 c_normal[];
out vec4 c_tangent[];
out vec2 c_uv[];
out vec4 c_sky[];
out vec4 c_far[];
out vec3 c_bounce[];
out vec4 c_direction[];
out vec3 c_gradient_u[];
out vec3 c_gradient_v[];

// Coordinates for the heights on the border; see DisplacementSeam. An edge's are its first end's and its second's.
patch out vec2 c_corner_uv[3];
patch out vec4 c_edge_uv[3];

layout(std430, binding = 7) readonly buffer Seams { float u_seams[]; };  // 18 a seam

// Pixels along the edge, seen from any side, over the pixels that a piece may have (the sphere around it: Cantlay 2011, "DirectX 11
// Terrain Tessellation").
float edgeFactor(int a, int b) {
  vec3 from = v_position[a], to = v_position[b];
  vec3 middle = 0.5 * (from + to);
  float factor = distance(from, to) * u_displace_detail.x / displaceDistance(middle);
  // What faces away is seen in holes and at the rim of deep relief only.
  vec3 to_eye = displaceToEye(middle);
  float facing = max(dot(v_direction[a].xyz, to_eye), dot(v_direction[b].xyz, to_eye));
  if (facing < u_displace_detail.w) factor *= 0.25;
  return clamp(factor, 1.0, u_displace_detail.y);
}

bool offScreen() {
  vec3 middle = (v_position[0] + v_position[1] + v_position[2]) / 3.0;
  float radius = max(max(distance(middle, v_position[0]), distance(middle, v_position[1])), distance(middle, v_position[2])) +
                 u_displace_reach;
  for (int i = 0; i < 4; ++i)
    if (dot(u_displace_planes[i].xyz, middle) + u_displace_planes[i].w < -radius) return true;
  return false;
}

void main() {
  c_position[gl_InvocationID] = v_position[gl_InvocationID];
  c_normal[gl_InvocationID] = v_normal[gl_InvocationID];
  c_tangent[gl_InvocationID] = v_tangent[gl_InvocationID];
  c_uv[gl_InvocationID] = v_uv[gl_InvocationID];
  c_sky[gl_InvocationID] = v_sky[gl_InvocationID];
  c_far[gl_InvocationID] = v_far[gl_InvocationID];
  c_bounce[gl_InvocationID] = v_bounce[gl_InvocationID];
  c_direction[gl_InvocationID] = v_direction[gl_InvocationID];
  c_gradient_u[gl_InvocationID] = v_gradient_u[gl_InvocationID];
  c_gradient_v[gl_InvocationID] = v_gradient_v[gl_InvocationID];
  if (gl_InvocationID != 0) return;

  bool hidden = offScreen();
  vec3 factors = hidden ? vec3(0.0) : vec3(edgeFactor(1, 2), edgeFactor(2, 0), edgeFactor(0, 1));
  gl_TessLevelOuter[0] = factors.x;
  gl_TessLevelOuter[1] = factors.y;
  gl_TessLevelOuter[2] = factors.z;
  gl_TessLevelInner[0] = (factors.x + factors.y + factors.z) / 3.0;

  if (u_displace_seam < 0) {
    for (int i = 0; i < 3; ++i) {
      c_corner_uv[i] = v_uv[i];
      c_edge_uv[i] = vec4(v_uv[(i + 1) % 3], v_uv[(i + 2) % 3]);
    }
  } else {
    uint at = uint(u_displace_seam + gl_PrimitiveID) * 18u;
    for (int i = 0; i < 3; ++i) {
      uint corner = at + 2u * uint(i), edge = at + 6u + 4u * uint(i);
      c_corner_uv[i] = vec2(u_seams[corner], u_seams[corner + 1u]);
      c_edge_uv[i] = vec4(u_seams[edge], u_seams[edge + 1u], u_seams[edge + 2u], u_seams[edge + 3u]);
    }
  }
}
