// What vertices know of the light that doesn't come straight from a lamp. None of it depends on the camera, so it is asked when light,
// material or mesh has changed, and kept with the vertices (renderer/passes/vertex_light.h).
#include "mesh_bake.glsl"
#ifdef DERMIS_FAR_LAMPS
#define DERMIS_NO_DERIVATIVES  // only fragments have neighbours
#include "models/skin.glsl"
#endif

layout(local_size_x = 64) in;

struct Vertex {
  vec4 position_u;
  vec4 normal_v;
  vec4 tangent;
};
layout(std430, binding = 0) readonly buffer Vertices { Vertex u_vertices[]; };

struct VertexLight {
  vec4 sky;     // share of the environment's irradiance that arrives; ambient occlusion
  vec4 far;     // irradiance/π of the far side; thickness in mm
  vec4 bounce;  // irradiance/π from other parts of the mesh
};
layout(std430, binding = 1) writeonly buffer Lights { VertexLight u_vertex_lights[]; };

layout(std430, binding = 3) readonly buffer CoarseVertices { uint u_coarse_vertices[]; };

uniform uint u_first;
uniform uint u_count;
uniform int u_listed;  // whether these count coarse vertices (renderer/core/scene/coarse_mesh.h)
uniform int u_baked;  // whether u_mesh_bake is there

void main() {
  if (gl_GlobalInvocationID.x >= u_count) return;
  uint vertex = u_first + gl_GlobalInvocationID.x;
  if (u_listed != 0) vertex = u_coarse_vertices[vertex];
  readMeshBake(vertex, u_baked != 0);
  vec3 position = u_vertices[vertex].position_u.xyz;
  vec3 normal = u_vertices[vertex].normal_v.xyz;
  BakedSky sky = bakedSky(position, normal);
  vec4 far = vec4(sky.far_light, a_hidden_8.y);
#ifdef DERMIS_FAR_LAMPS
  vec2 uv = vec2(u_vertices[vertex].position_u.w, u_vertices[vertex].normal_v.w);
  far = farSideWithLamps(position, normalize(normal), uv, far);
#endif
  u_vertex_lights[vertex] = VertexLight(vec4(sky.share, sky.open), far, vec4(sky.bounce, 0.0));
}
