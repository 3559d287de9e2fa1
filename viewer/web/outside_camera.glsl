// The orbiting camera and its light, shared by the shaders of the outside view. Where kHandOn is
// defined, pixels have their numbers from the vertices, by way of handOn(): where there is no graphics
// card, reading a uniform takes some twenty instructions a pixel for each number, and this takes one.
#if defined(kHandOn) && !kVertex
flat in vec4 vHanded[6];
#define kAcross vHanded[0].xyz
#define kUp vHanded[1].xyz
#define kForward vHanded[2].xyz
#define uAxes mat3(kAcross, kUp, kForward)
#define uPixel vHanded[2].w
#define uKey vHanded[3].xyz
#define uSoft vHanded[3].w
#define uEye vHanded[4].xyz
#define uOutput int(vHanded[4].w)

vec3 rayThroughPixel(vec2 pixel) {
  return normalize(kAcross * (pixel.x * uPixel - vHanded[0].w) +
                   kUp * (pixel.y * uPixel - vHanded[1].w) + kForward);
}
float depthOf(float distance) {
  return clamp((distance - vHanded[5].x) * vHanded[5].y, 0.0, 1.0);
}
float heightOnPicture(float y) { return y * vHanded[5].z; }
#else
uniform vec3 uEye;
uniform mat3 uAxes;       // columns: right, up, forward
uniform vec2 uTangent;    // of half the field of view, across and up
uniform vec2 uSize;       // of the picture in pixels
uniform float uPixel;     // the angle of a pixel
uniform vec2 uDepth;      // distances that become depth 0 and 1
uniform vec3 uKey;        // unit, towards the light
uniform float uSoft;      // 1 / width of the outline of the glass ball, in cosines; 0 without a ball

#if defined(kHandOn)
flat out vec4 vHanded[6];
void handOn() {
  vHanded[0] = vec4(uAxes[0], uTangent.x);
  vHanded[1] = vec4(uAxes[1], uTangent.y);
  vHanded[2] = vec4(uAxes[2], uPixel);
  vHanded[3] = vec4(uKey, uSoft);
  vHanded[4] = vec4(uEye, float(uOutput));
  vHanded[5] = vec4(uDepth.x, 1.0 / (uDepth.y - uDepth.x), 1.0 / uSize.y, 0.0);
}
#endif

vec3 rayThroughPixel(vec2 pixel) {
  vec2 ndc = 2.0 * pixel / uSize - 1.0;
  return normalize(uAxes * vec3(ndc * uTangent, 1.0));
}
float depthOf(float distance) {
  return clamp((distance - uDepth.x) / (uDepth.y - uDepth.x), 0.0, 1.0);
}
/// From 0 at the lower end of the picture to 1.
float heightOnPicture(float y) { return y / uSize.y; }
#endif
uniform vec3 uInk;        // of the glass ball

/// The rim of the glass ball seen along a ray: 0 in the middle and outside.
float glass(vec3 ray) {
  float b = dot(uEye, ray), c = dot(uEye, uEye) - 1.0;
  float facing = sqrt(max(b * b - c, 0.0));  // the cosine at which the ray meets the unit sphere
  float soft = min(facing * uSoft, 1.0), rim = 1.0 - min(facing, 1.0), rim2 = rim * rim;
  return soft * soft * (3.0 - 2.0 * soft) * rim2 * rim2;
}
/// What is seen through its near side.
vec3 throughGlass(vec3 shown, vec3 ray) { return mix(shown, uInk, 0.22 * glass(ray)); }
