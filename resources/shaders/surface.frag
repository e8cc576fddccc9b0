// One fragment of the model: fills Surface, asks the shading model, writes the picture and, with DERMIS_AOVS, its parts.
#include "frame_block.glsl"
#include "draw_block.glsl"
#include "surface_types.glsl"
#include DERMIS_MODEL

#ifdef DERMIS_DEFERRED
// The surface that geometry.frag left under each pixel.
layout(binding = 21) uniform sampler2D u_surface;
layout(binding = 22) uniform sampler2D u_tangent;
layout(binding = 23) uniform sampler2D u_depth;
uniform int u_slot;  // shades the pixels of this one
#else
in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;
#endif

// Premultiplied radiance; alpha is coverage.
layout(location = 0) out vec4 o_beauty;
#ifdef DERMIS_AOVS
layout(location = 1) out vec4 o_diffuse;
layout(location = 2) out vec4 o_specular;
layout(location = 3) out vec4 o_normal;  // shading normal in world space, coverage
layout(location = 4) out vec4 o_data;    // occlusion, depth along the view in scene units, 0, coverage
layout(location = 5) out float o_profile_id;
#endif

#ifdef DERMIS_DEFERRED
vec3 fromOctahedron(vec2 e) {
  vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
  if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
  return normalize(n);
}

Surface surfaceHere() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 tangent = texelFetch(u_tangent, pixel, 0);
  int code = int(tangent.w);
  if ((code >> 2) != u_slot + 1) discard;
  vec4 surface = texelFetch(u_surface, pixel, 0);
  vec4 clip = vec4(gl_FragCoord.xy * u_viewport.zw * 2.0 - 1.0, texelFetch(u_depth, pixel, 0).r, 1.0);
  vec4 world = u_inverse_view_projection * clip;
  Surface s;
  s.position = world.xyz / world.w;
  s.normal = fromOctahedron(surface.zw);
  s.geometric_normal = s.normal;
  s.tangent = vec4(tangent.xyz, (code & 1) != 0 ? 1.0 : -1.0);
  s.uv = surface.xy;
  s.front_facing = (code & 2) != 0;
  return s;
}
#else
Surface surfaceHere() {
  Surface s;
  s.position = v_position;
  s.normal = normalize(v_normal);
  s.geometric_normal = normalize(cross(dFdx(v_position), dFdy(v_position)));
  s.tangent = v_tangent;
  s.uv = v_uv;
  s.front_facing = gl_FrontFacing;
  return s;
}
#endif

void main() {
  Surface s = surfaceHere();
  s.view = u_camera_position.w > 0.5 ? -u_camera_forward.xyz : normalize(u_camera_position.xyz - s.position);

  Shading shading = shade(s);
  o_beauty = vec4(shading.diffuse + shading.specular, shading.alpha);
#ifdef DERMIS_AOVS
  o_diffuse = vec4(shading.diffuse, shading.alpha);
  o_specular = vec4(shading.specular, shading.alpha);
  o_normal = vec4(shading.shading_normal, 1.0);
  o_data = vec4(shading.occlusion, dot(s.position - u_camera_position.xyz, u_camera_forward.xyz), 0.0, 1.0);
  o_profile_id = float(u_map_bits.w);
#endif
}
