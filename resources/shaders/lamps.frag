// A lamp of radiant intensity I and radius r is a sphere of radiance I / (π r²): that is what its irradiance asks for.
uniform vec3 u_radiance;

layout(location = 0) out vec4 o_beauty;

void main() { o_beauty = vec4(u_radiance, 1.0); }
