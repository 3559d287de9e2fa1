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

uniform vec3 uInk;        // of the glass ball
uniform float uGlass;     // 1: there is one, the unit ball; 0: there is none
uniform float uSoft;      // 1 / width of its outline, in cosines

/// The rim of the glass ball seen along a ray: 0 in the middle and outside.
float glass(vec3 ray) {
  float b = dot(uEye, ray), c = dot(uEye, uEye) - 1.0;
  float facing = sqrt(max(b * b - c, 0.0));  // the cosine at which the ray meets the unit sphere
  float soft = min(facing * uSoft, 1.0), rim = 1.0 - min(facing, 1.0), rim2 = rim * rim;
  return uGlass * soft * soft * (3.0 - 2.0 * soft) * rim2 * rim2;
}
/// What is seen through its near side.
vec3 throughGlass(vec3 shown, vec3 ray) { return mix(shown, uInk, 0.22 * glass(ray)); }
