// One triangle over the whole viewport, at the far plane of the reversed depth.
out vec2 v_clip;  // −1..1

void main() {
  v_clip = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0;
  gl_Position = vec4(v_clip, 0.0, 1.0);
}
