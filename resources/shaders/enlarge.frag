// A picture of codes shown larger than it was drawn. GL's own blit would do, but software GL compiles its program anew in each process.
layout(binding = 0) uniform sampler2D u_image;
uniform vec2 u_scale;  // 1 / pixels of the framebuffer

layout(location = 0) out vec4 o_colour;

void main() { o_colour = textureLod(u_image, gl_FragCoord.xy * u_scale, 0.0); }
