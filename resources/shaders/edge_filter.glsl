// Smooths stair steps in a moving picture where four samples a pixel would cost too much: after Lottes 2009, "FXAA", without its
// search along the edge. Contrast is relative, so that it needs no tone curve; only pixels on an edge fetch and encode more.

float edgeLuma(vec2 pixel) {
  vec4 scene = sceneAt(pixel);
  return dot(scene, vec4(0.2126, 0.7152, 0.0722, 0.25));
}

// Between texels.
vec4 sceneBetween(vec2 pixel) { return textureLod(u_image, pixel / vec2(textureSize(u_image, 0)), 0.0) * u_weight; }

// Radiance is blended as 1 − 1/(1 + luminance), which displays show about evenly: encoding each of three would cost twice what all else does.
vec4 squeezed(vec4 scene) { return vec4(scene.rgb / (1.0 + u_exposure * dot(scene.rgb, vec3(0.2126, 0.7152, 0.0722))), scene.a); }
vec4 stretched(vec4 scene) {
  return vec4(scene.rgb / max(1.0 - u_exposure * dot(scene.rgb, vec3(0.2126, 0.7152, 0.0722)), 1e-4), scene.a);
}

vec4 edgeFiltered(vec2 pixel) {
  vec4 centre = sceneAt(pixel);
  vec2 least = vec2(0.5);
  vec2 most = vec2(textureSize(u_image, 0)) - 0.5;
  vec2 ne = clamp(pixel + vec2(1.0, 1.0), least, most);
  vec2 nw = clamp(pixel + vec2(-1.0, 1.0), least, most);
  vec2 se = clamp(pixel + vec2(1.0, -1.0), least, most);
  vec2 sw = clamp(pixel + vec2(-1.0, -1.0), least, most);
  float l_ne = edgeLuma(ne), l_nw = edgeLuma(nw), l_se = edgeLuma(se), l_sw = edgeLuma(sw);
  float l_min = min(min(l_ne, l_nw), min(l_se, l_sw));
  float l_max = max(max(l_ne, l_nw), max(l_se, l_sw));
  // Across the edge the luminance changes, along it it doesn't: blend along it.
  vec2 along = vec2((l_se + l_sw) - (l_ne + l_nw), (l_ne + l_se) - (l_nw + l_sw));
  float shortest = min(abs(along.x), abs(along.y)) + max((l_ne + l_nw + l_se + l_sw) / 32.0, 1e-4);
  along = clamp(along / shortest, -2.0, 2.0);
  vec4 a = squeezed(sceneBetween(clamp(pixel + along * 0.5, least, most)));
  vec4 b = squeezed(sceneBetween(clamp(pixel - along * 0.5, least, most)));
  vec4 blended = stretched((a + b + 2.0 * squeezed(centre)) * 0.25);
  // A step of a fifth, unless it is too dark to be seen.
  bool edge = l_max - l_min >= 0.1 * (l_max + l_min) + 0.004 / u_exposure;
  return displayed(edge ? blended : centre);
}
