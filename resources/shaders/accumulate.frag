// Adds one sample's image to the running sum (blending does the sum; the largest for the profile id).
layout(binding = 0) uniform sampler2D u_image;

layout(location = 0) out vec4 o_sum;

void main() { o_sum = texelFetch(u_image, ivec2(gl_FragCoord.xy), 0); }
