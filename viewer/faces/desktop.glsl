// The camera of the desktop viewer (view_of in camera.cpp), for faces.glsl.
uniform vec3 uEye;
uniform mat3 uAxes;       // columns: right, up, forward
uniform vec2 uTangent;    // of half the field of view, across and up
uniform vec2 uShift;      // of the picture, in halves of its sides
uniform vec2 uSize;       // of the picture in pixels
uniform vec2 uDepth;      // near, far
uniform float uPixel;     // the angle of a pixel

vec3 rayThroughPixel(vec2 pixel) {
  vec2 ndc = 2.0 * pixel / uSize - 1.0 - uShift;
  return normalize(uAxes * vec3(ndc * uTangent, 1.0));
}
/// What OpenGL's projection makes of a depth along the axis of the camera.
float depthOf(float ahead) {
  return clamp(uDepth.y * (ahead - uDepth.x) / (ahead * (uDepth.y - uDepth.x)), 0.0, 1.0);
}
