// One cell of the universal cover: the intersection of eight half-spaces. In both models each is
//   q(u) = A |u|^2 + 2 b.u + C <= 0,
// a ball, the complement of a ball, or a Euclidean half-space. The numbers are in units of the
// cell's own bounding sphere (u = (p - centre) / radius, |b|^2 - A C = 1), computed in doubles, so
// that single precision serves the smallest cells as well as the largest.
uniform sampler2D uCells;
uniform int uColourBy;  // 0 tetrahedron, 1 depth, 2 face
uniform vec3 uPalette[48];  // for faces; as many as kColourCount of embedding/colour.hpp
uniform vec3 uDepths[12];
uniform float uLine;    // thickness of the edges in pixels

flat in ivec2 vFirst;
flat in int vCell;
flat in vec3 vCentre;
flat in float vRadius;
out vec4 colour;

vec4 gSphere[8];  // b, A
float gC[8];

float valueAt(int i, vec3 u) {
  return gSphere[i].w * dot(u, u) + 2.0 * dot(gSphere[i].xyz, u) + gC[i];
}
vec3 slopeAt(int i, vec3 u) { return gSphere[i].w * u + gSphere[i].xyz; }

/// Where the ray o + s d enters the cell first, s in [start, stop]; -1 in `surface` if it never
/// does. The balls hold the ray in one interval together. Each complement of a ball is an obstacle
/// in it: s moves on to the end of each until nothing stands in its way.
float enter(vec3 o, vec3 d, float start, float stop, out int surface) {
  float low[8], high[8];
  int obstacles = 0;
  int number[8];
  float s = start;
  surface = -1;
  for (int i = 0; i < 8; ++i) {
    float a = gSphere[i].w;
    float b = a * dot(o, d) + dot(gSphere[i].xyz, d);
    float c = valueAt(i, o);
    if (abs(a) < 1e-7) a = a < 0.0 ? -1e-7 : 1e-7;
    float discriminant = b * b - a * c;
    if (discriminant < 0.0) {
      if (a > 0.0) { surface = -1; return s; }  // the ray misses a ball
      continue;
    }
    float q = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
    float first = q / a, second = abs(q) > 1e-30 ? c / q : 0.0;
    float near = min(first, second), far = max(first, second);
    if (a > 0.0) {
      if (near > s) { s = near; surface = i; }
      stop = min(stop, far);
      if (s > stop) { surface = -1; return s; }
    } else if (far > start) {
      low[obstacles] = near;
      high[obstacles] = far;
      number[obstacles++] = i;
    }
  }
  for (int turn = 0; turn <= obstacles; ++turn) {
    bool moved = false;
    for (int k = 0; k < obstacles; ++k) {
      if (s > low[k] && s < high[k]) { s = high[k]; surface = number[k]; moved = true; }
    }
    if (s > stop) { surface = -1; return s; }
    if (!moved) break;
  }
  return s;
}

/// The discs at a point of a truncation, seen along `ray`; `pixel`: its size in units of u.
vec3 discsAt(int surface, vec3 u, float pixel, vec3 ray, out int disc) {
  vec4 x = texelFetch(uCells, vFirst + ivec2(17, 0), 0) +
           texelFetch(uCells, vFirst + ivec2(16, 0), 0) * dot(u, u);
  for (int k = 0; k < 3; ++k) x += texelFetch(uCells, vFirst + ivec2(13 + k, 0), 0) * u[k];
  float scale = inversesqrt(max(-discProduct(x, x), 1e-30));
  float incidence = max(abs(dot(normalize(slopeAt(surface, u)), ray)), 0.06);
  float first = texelFetch(uCells, vFirst + ivec2(18, 0), 0)[surface - 4];
  return discColour(int(first), x * scale, pixel * scale / incidence, disc);
}

vec3 paint(int surface, vec4 own) {
  vec4 faceColours = texelFetch(uCells, vFirst + ivec2(12, 0), 0);
  vec3 base = own.rgb;
  if (uColourBy == 1) base = uDepths[min(int(own.w), 11)];
  if (uColourBy == 2 && surface < 4) base = uPalette[int(faceColours[surface]) % 48];
  // Truncations, the geodesic boundary, are pale, whatever the colours say.
  return surface < 4 ? base : mix(base, vec3(0.95, 0.93, 0.88), 0.40);
}

/// 1 on an edge of the cell, 0 away from it.
float edgeLine(int surface, vec3 u, vec3 normal, float s) {
  float pixel = s * uPixel, line = 0.0;
  for (int i = 0; i < 8; ++i) {
    if (i == surface) continue;
    vec3 slope = slopeAt(i, u);
    float steep = length(slope);
    float cosine = dot(slope, normal) / steep;
    float away = -valueAt(i, u) / (2.0 * steep * max(sqrt(1.0 - cosine * cosine), 0.05));
    // Edges between faces are the edges of the triangulation; those of truncations are thinner.
    float width = uLine * pixel * (surface < 4 && i < 4 ? 1.0 : 0.6);
    line = max(line, 1.0 - smoothstep(0.55 * width, 0.55 * width + 0.9 * pixel, away));
  }
  return line;
}

void main() {
  vec3 ray = rayThroughPixel(gl_FragCoord.xy);
  vec3 toCentre = (uEye - vCentre) / vRadius;
  float nearest = -dot(toCentre, ray);
  vec3 o = toCentre + nearest * ray;  // the point of the ray nearest to the centre
  float across = dot(o, o);
  if (across > 1.0) discard;
  for (int i = 0; i < 8; ++i) gSphere[i] = texelFetch(uCells, vFirst + ivec2(i, 0), 0);
  for (int i = 0; i < 8; ++i) gC[i] = texelFetch(uCells, vFirst + ivec2(8 + i / 4, 0), 0)[i & 3];

  // Beyond the bounding sphere the eight inequalities also hold in the cell's mirror image in the
  // sphere or plane at infinity.
  float halfChord = sqrt(1.0 - across);
  int surface;
  float s = enter(o, ray, max(-nearest, -halfChord), halfChord, surface);
  if (surface < 0) discard;
  vec3 u = o + s * ray;
  float along = nearest + s;
  gl_FragDepth = depthOf(along * vRadius);
  int disc = 0;
  vec3 spots = vec3(0.0);
  bool spotted = uDiscsOn == 1 && surface >= 4;
  if (spotted) spots = discsAt(surface, u, along * uPixel, ray, disc);
  if (uOutput == kIdentities) {
    colour = vec4(float(vCell & 255), float(vCell >> 8), float(surface + 1) + discIdentity(disc),
                  255.0) / 255.0;
    return;
  }
  vec4 own = texelFetch(uCells, vFirst + ivec2(11, 0), 0);
  vec3 normal = normalize(slopeAt(surface, u));
  vec3 shade = lit(spotted ? spots : paint(surface, own), normal, ray);
  shade *= 1.0 - 0.82 * edgeLine(surface, u, normal, along);
  colour = finite(throughGlass(toDisplay(shade), ray));
}
