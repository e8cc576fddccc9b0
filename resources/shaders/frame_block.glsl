// What every shader of a frame knows: camera, environment, lights. C++ twin: FrameBlock in renderer/passes/uniform_blocks.h.

struct LightData {
  vec4 position_type;    // xyz world, scene units; w the type, see lights.glsl
  vec4 direction_outer;  // xyz unit, the way the light travels; w cosine of the spot's outer half angle
  vec4 radiant_inner;    // rgb color * intensity; w cosine of the spot's inner half angle
  vec4 size;             // x radius, yz half sizes of a rect, w radius of what the light's point in this sample stands for; scene units
};

layout(std140, binding = 0) uniform FrameBlock {
  mat4 u_view;
  mat4 u_projection;
  mat4 u_view_projection;
  mat4 u_inverse_view_projection;
  vec4 u_camera_position;  // xyz world; w 1 for an orthographic camera
  vec4 u_camera_forward;   // xyz unit, the way the camera looks
  mat4 u_environment_from_world;  // rotation
  vec4 u_environment_scale;       // x 2^exposure times what the stored maps are scaled by
  vec4 u_viewport;                // width, height, 1/width, 1/height
  ivec4 u_light_count;            // x
  vec4 u_units;                   // x millimetres per scene unit
  LightData u_lights[16];
  vec4 u_environment_harmonics[9];  // rgb radiance in real spherical harmonics in world axes, exposure included
};

// What differs from one accumulated sample to the next. C++ twin: SampleBlock.
layout(std140, binding = 5) uniform SampleBlock {
  ivec4 u_sampling;  // x index of the accumulated sample, y 1 while moving, z 1 where the view switches subsurface off,
                     // w samples that the picture will have
  vec4 u_random;     // four numbers in 0..1, evenly spread over the samples
  vec4 u_window;     // xy lower left corner, in the picture, of the part that is drawn; pixels
};
