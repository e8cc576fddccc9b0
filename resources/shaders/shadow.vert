// A caster as a light sees it.
layout(location = 0) in vec4 a_position_u;
layout(location = 1) in vec4 a_normal_v;

uniform mat4 u_clip_from_world;  // of a position relative to the centre
uniform vec3 u_centre;

#ifdef DERMIS_CUT_OUTS
out vec2 v_uv;
#endif

void main() {
#ifdef DERMIS_CUT_OUTS
  v_uv = vec2(a_position_u.w, a_normal_v.w);
#endif
  gl_Position = u_clip_from_world * vec4(a_position_u.xyz - u_centre, 1.0);
}
