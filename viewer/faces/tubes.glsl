// Where the ray of a pixel meets a piece of the tube of points at hyperbolic distance r from an edge:
// tubes.vert.glsl has its numbers. After a camera and before a main() that gives the colour. With
// f and g the products of a point with two orthonormal normals of the edge, times the model's factor
// h, the tube is f^2 + g^2 <= sinh^2 r h^2: a polynomial of degree 4 along the ray. Defined in front
// of it: kModel, 0 upper half-space, 1 Poincare ball, 2 Klein ball; kCut, whether uCut is heeded.
uniform float uCut;

flat in vec4 vAcross[2];
flat in vec4 vFactor;
flat in vec4 vEnds[2];
flat in vec4 vConstants;
flat in vec4 vAbout;
flat in vec4 vEye;
flat in vec3 vCentre;
flat in vec3 vColour;

/// Pieces reach beyond their ends by so much, so that no gap is between two of them.
const float kTubeOverlap = 1e-4;

struct TubeMeeting {
  float along;     // from the eye, in radii of the piece
  vec3 normal;     // outward, of length 1
  float coverage;  // of the pixel
};

/// A polynomial of u along o + s ray, by the powers of s from 2 to 0; o.ray is 0.
vec3 along(vec4 polynomial, float constant, vec3 o, vec3 ray) {
  return vec3(polynomial.w, dot(polynomial.xyz, ray),
              polynomial.w * dot(o, o) + dot(polynomial.xyz, o) + constant);
}
float valueOf(vec3 p, float s) { return (p.x * s + p.y) * s + p.z; }
float slopeOf(vec3 p, float s) { return 2.0 * p.x * s + p.y; }
vec3 gradientOf(vec4 polynomial, vec3 u) { return 2.0 * polynomial.w * u + polynomial.xyz; }

/// Where the ray goes into a half-space, not before s; beyond everything if it does not.
float entry(vec3 end, float s) {
  if (valueOf(end, s) <= kTubeOverlap) return s;
  for (int i = 0; i < 4; ++i) {
    float slope = slopeOf(end, s);
    if (slope > -1e-4) return 1e9;
    s -= valueOf(end, s) / slope;
  }
  return s;
}

bool meetTube(vec3 ray, out TubeMeeting met) {
  float nearest = -dot(vEye.xyz, ray);
  vec3 o = vEye.xyz + nearest * ray;  // the point of the ray nearest to the middle of the piece
  vec3 f = along(vAcross[0], vConstants.x, o, ray), g = along(vAcross[1], vConstants.y, o, ray);
  vec3 h = along(vFactor, vConstants.z, o, ray);
  vec3 end = along(vEnds[0], vConstants.w, o, ray), other = along(vEnds[1], vAbout.x, o, ray);
  // Where it is nearest to the edge: the edge is nearly straight, and so are f and g.
  float s = 0.0, steep = 1.0;
  for (int i = 0; i < 4; ++i) {
    float a = slopeOf(f, s), b = slopeOf(g, s);
    steep = max(a * a + b * b, 1e-6);
    s = clamp(s - (a * valueOf(f, s) + b * valueOf(g, s)) / steep, -1.2, 1.2);
  }
  float away = length(vec2(valueOf(f, s), valueOf(g, s)));
  float pixel = uPixel * (nearest + s) * dot(ray, uAxes[2]);
#if kModel == 2
  float square = max(valueOf(h, s), 1e-12);
#else
  float square = max(valueOf(h, s) * valueOf(h, s), 1e-12);
#endif
  float radius = max(sqrt(vAbout.y * square), vAbout.z * pixel);
  float sinh2 = radius * radius / square;
  float beyond = (away - radius) / max(pixel, 1e-12);
  met.coverage = clamp(0.5 - beyond, 0.0, 1.0);
  if (!(met.coverage > 0.0)) return false;
  float last = s;
  if (beyond < 0.0) {
    float reach = min(sqrt((radius - away) * (radius + away) / steep), 1.2);
    last = s + reach;
    s -= reach;
    for (int i = 0; i < 3; ++i) {
      float a = valueOf(f, s), b = valueOf(g, s), c = valueOf(h, s);
#if kModel == 2
      float value = a * a + b * b - sinh2 * c;
      float slope = 2.0 * (a * slopeOf(f, s) + b * slopeOf(g, s)) - sinh2 * slopeOf(h, s);
#else
      float value = a * a + b * b - sinh2 * c * c;
      float slope = 2.0 * (a * slopeOf(f, s) + b * slopeOf(g, s) - sinh2 * c * slopeOf(h, s));
#endif
      if (slope < -1e-9) s -= clamp(value / slope, -0.25, 0.25);
    }
  }
  // Where the tube ends, its inside is met.
  float first = s, at = max(entry(end, s), entry(other, s));
  vec4 cap = valueOf(end, s) > valueOf(other, s) ? vEnds[0] : vEnds[1];
#if kCut
  vec3 cut = vec3(0.0, vEye.w * ray.x, vCentre.x + vEye.w * o.x - uCut) / vEye.w;
  float opened = entry(cut, s);
  if (opened > at) cap = vec4(1.0, 0.0, 0.0, 0.0);
  at = max(at, opened);
#endif
  if (at > last || valueOf(end, at) > 2.0 * kTubeOverlap || valueOf(other, at) > 2.0 * kTubeOverlap)
    return false;
  vec3 u = o + at * ray;
  if (at > first) {
    met.normal = normalize(gradientOf(cap, u));
  } else {
    vec3 outward = valueOf(f, at) * gradientOf(vAcross[0], u) +
                   valueOf(g, at) * gradientOf(vAcross[1], u);
#if kModel == 2
    outward -= 0.5 * sinh2 * gradientOf(vFactor, u);
#else
    outward -= sinh2 * valueOf(h, at) * gradientOf(vFactor, u);
#endif
    met.normal = outward * inversesqrt(max(dot(outward, outward), 1e-20));
  }
  met.along = nearest + at;
  return met.along > 0.0;
}
