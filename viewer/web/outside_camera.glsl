// The orbiting camera, shared by the shaders of the outside view.
uniform vec3 uEye;
uniform mat3 uAxes;       // columns: right, up, forward
uniform vec2 uTangent;    // of half the field of view, across and up
uniform vec2 uSize;       // of the picture in pixels
uniform float uPixel;     // the angle of a pixel
uniform vec2 uDepth;      // distances that become depth 0 and 1

vec3 rayThroughPixel(vec2 pixel) {
  vec2 ndc = 2.0 * pixel / uSize - 1.0;
  return normalize(uAxes * vec3(ndc * uTangent, 1.0));
}
float depthOf(float distance) {
  return clamp((distance - uDepth.x) / (uDepth.y - uDepth.x), 0.0, 1.0);
}
