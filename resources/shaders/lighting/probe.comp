// Evaluates the lookups of environment.glsl and dfg.glsl at given places: `dermis bake` and tests read what shading reads.
#include "frame_block.glsl"
#include "lighting/environment.glsl"

layout(local_size_x = 64) in;

// xyz a direction; w a perceptual roughness, or one of these.
const float PROBE_IRRADIANCE = -1.0;
const float PROBE_SHARP = -2.0;
const float PROBE_DFG_SMITH = -3.0;        // x n.v, y perceptual roughness
const float PROBE_DFG_SCHLICK_IBL = -4.0;  // the same

layout(std430, binding = 0) readonly buffer Queries { vec4 u_queries[]; };
layout(std430, binding = 1) writeonly buffer Answers { vec4 u_answers[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(u_queries.length())) return;
  vec4 q = u_queries[i];
  vec3 answer;
  if (q.w >= 0.0) answer = environmentPrefiltered(q.xyz, q.w);
  else if (q.w == PROBE_IRRADIANCE) answer = environmentIrradiance(q.xyz);
  else if (q.w == PROBE_SHARP) answer = environmentSharp(q.xyz);
  else if (q.w == PROBE_DFG_SMITH) answer = vec3(dfgSmith(q.x, q.y), 0.0);
  else answer = vec3(dfgSchlickIbl(q.x, q.y), 0.0);
  u_answers[i] = vec4(answer, 1.0);
}
