// One fragment of the model: fills Surface, asks the shading model, writes the picture or the parts that later passes make it of.
#include "frame_block.glsl"
#include "draw_block.glsl"
#include "octahedron.glsl"
#include "surface_types.glsl"
#include DERMIS_MODEL

#ifdef DERMIS_DEFERRED
// The surface that geometry.frag left under each pixel.
layout(binding = 21) uniform sampler2D u_surface;
layout(binding = 22) uniform sampler2D u_tangent;
layout(binding = 23) uniform sampler2D u_depth;
layout(binding = 29) uniform sampler2D u_sky;
layout(binding = 30) uniform sampler2D u_far;
layout(binding = 31) uniform sampler2D u_bounce;
#ifdef DERMIS_GRADIENTS
layout(binding = 32) uniform sampler2D u_gradients;
#endif
uniform int u_slot;  // shades the pixels of this one
#else
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
#endif

// What is written, by location (SceneImage in renderer/passes/render_targets.h). Radiances are premultiplied.
//   nothing set               0 the picture
//   DERMIS_SPLIT              0 what does not go through the body, 1 to 3 what the subsurface pass needs
//   DERMIS_AOVS, after that   4 to 7 parts to look at
//   DERMIS_BLENDED_AOVS       what is drawn over a finished picture and its parts
layout(location = 0) out vec4 o_beauty;
#ifdef DERMIS_SPLIT
layout(location = 1) out vec4 o_entering;  // a: share that diffuses
layout(location = 2) out vec4 o_exit;      // a: energy
layout(location = 3) out vec4 o_geometry;  // vertex normal on the octahedron, profile id, thickness in mm
#ifdef DERMIS_AOVS
layout(location = 4) out vec4 o_specular;
layout(location = 5) out vec4 o_transmission;
layout(location = 6) out vec4 o_normal;  // shading normal in world space, coverage
layout(location = 7) out vec4 o_data;    // occlusion, depth along the view in scene units, thickness in mm, coverage
#endif
#endif
#ifdef DERMIS_BLENDED_AOVS
layout(location = 1) out vec4 o_diffuse;
layout(location = 2) out vec4 o_scattered;
layout(location = 3) out vec4 o_specular;
layout(location = 4) out vec4 o_transmission;
#endif

#ifdef DERMIS_DEFERRED
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
  s.tangent = vec4(tangent.xyz, (code & 1) != 0 ? 1.0 : -1.0);
  s.uv.uv = surface.xy;
#ifdef DERMIS_GRADIENTS
  vec4 gradients = texelFetch(u_gradients, pixel, 0);
  s.uv.dx = gradients.xy;
  s.uv.dy = gradients.zw;
#endif
  s.front_facing = (code & 2) != 0;
  vec4 sky = texelFetch(u_sky, pixel, 0), far = texelFetch(u_far, pixel, 0);
  s.sky_share = sky.rgb;
  s.baked_occlusion = sky.a;
  s.far_light = far.rgb;
  s.baked_thickness_mm = far.a;
  s.bounce = texelFetch(u_bounce, pixel, 0).rgb;
  return s;
}
#else
Surface surfaceHere() {
  Surface s;
  s.position = v_position;
  s.normal = normalize(v_normal);
#ifdef DERMIS_DISPLACED
  s.normal = displacedNormal(s.normal, v_uv, v_gradient_u, v_gradient_v, v_curvature);
#endif
  s.tangent = v_tangent;
  s.uv.uv = v_uv;
  s.front_facing = gl_FrontFacing;
  s.sky_share = v_sky.rgb;
  s.baked_occlusion = v_sky.a;
  s.far_light = v_far.rgb;
  s.baked_thickness_mm = v_far.a;
  s.bounce = v_bounce;
  return s;
}
#endif

void main() {
  Surface s = surfaceHere();
  s.view = u_camera_position.w > 0.5 ? -u_camera_forward.xyz : normalize(u_camera_position.xyz - s.position);

  Shading shading = shade(s);
  vec3 diffuse = shading.entering * shading.exit;
#ifdef DERMIS_SPLIT
  float diffusing = u_sampling.z == 0 ? shading.subsurface : 0.0;
  o_beauty = vec4(shading.specular + shading.transmission, shading.alpha);
  o_entering = vec4(shading.entering, diffusing);
  o_exit = vec4(shading.exit, shading.energy);
  o_geometry = vec4(toOctahedron(facingNormal(s)), float(u_map_bits.w), shading.thickness_mm);
#ifdef DERMIS_AOVS
  o_specular = vec4(shading.specular, shading.alpha);
  o_transmission = vec4(shading.transmission, shading.alpha);
  o_normal = vec4(shading.shading_normal, 1.0);
  o_data = vec4(shading.occlusion, dot(s.position - u_camera_position.xyz, u_camera_forward.xyz), shading.thickness_mm, 1.0);
#endif
#else
  o_beauty = vec4(diffuse + shading.specular + shading.transmission, shading.alpha);
#endif
#ifdef DERMIS_BLENDED_AOVS
  o_diffuse = vec4(diffuse, shading.alpha);
  o_scattered = o_diffuse;
  o_specular = vec4(shading.specular, shading.alpha);
  o_transmission = vec4(shading.transmission, shading.alpha);
#endif
}
