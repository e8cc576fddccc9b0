// One fragment of the model: fills Surface, asks the shading model, writes the picture and, with DERMIS_AOVS, its parts.
#include "frame_block.glsl"
#include "draw_block.glsl"
#include "surface_types.glsl"
#include DERMIS_MODEL

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;

// Premultiplied radiance; alpha is coverage.
layout(location = 0) out vec4 o_beauty;
#ifdef DERMIS_AOVS
layout(location = 1) out vec4 o_diffuse;
layout(location = 2) out vec4 o_specular;
layout(location = 3) out vec4 o_normal;  // shading normal in world space, coverage
layout(location = 4) out vec4 o_data;    // occlusion, depth along the view in scene units, 0, coverage
layout(location = 5) out float o_profile_id;
#endif

void main() {
  Surface s;
  s.position = v_position;
  s.normal = normalize(v_normal);
  s.geometric_normal = normalize(cross(dFdx(v_position), dFdy(v_position)));
  s.tangent = v_tangent;
  s.view = u_camera_position.w > 0.5 ? -u_camera_forward.xyz : normalize(u_camera_position.xyz - v_position);
  s.uv = v_uv;
  s.front_facing = gl_FrontFacing;

  Shading shading = shade(s);
  o_beauty = vec4(shading.diffuse + shading.specular, shading.alpha);
#ifdef DERMIS_AOVS
  o_diffuse = vec4(shading.diffuse, shading.alpha);
  o_specular = vec4(shading.specular, shading.alpha);
  o_normal = vec4(shading.shading_normal, 1.0);
  o_data = vec4(shading.occlusion, dot(v_position - u_camera_position.xyz, u_camera_forward.xyz), 0.0, 1.0);
  o_profile_id = float(u_map_bits.w);
#endif
}
