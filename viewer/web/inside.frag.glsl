// Standing in the manifold: each pixel follows a geodesic x cosh s + u sinh s through the
// tetrahedra. In the coordinates of the current one a plane <n, x> = 0 ahead is met where
// tanh s = -<n, x> / <n, u>. At a face the geodesic goes on in the neighbour's coordinates; at a
// truncation plane it has met the geodesic boundary, at a horosphere <v, x> = -1 a cusp: the wall.
// Coordinates in one tetrahedron stay small, which is what single precision needs. kKinds is defined
// in front of this text: 0 where all vertices are hyperideal, 1 where some are not, 2 where there are
// parabolic edges, which are walls: of edge e number 4 + e, a horosphere around s (v_i + v_j).
//
// Texels of a tetrahedron (normals come with their time negated, so that dot() is the product):
//   0-3 faces, 4-7 vertices, 8-23 rows of the four crossings, 24 neighbours, 25 entry faces,
//   26-27 cosines g = <n_k, n_l> at the six edges, 28-29 edge classes, 30 boundary components,
//   31 where the discs of the four truncations begin, 32-33 1 / (1 - g^2) at the edges, of parabolic
//   ones -s,
//   34 kinds of the vertices: 1 hyperideal, 0 ideal, -1 finite, 35-36 1 at singular edges
const int kTexels = 37;
uniform sampler2D uTetrahedra;
uniform int uPerRow;
uniform int uStart;       // the tetrahedron of the camera
uniform mat4 uFrame;      // columns: right, up, forward, position
uniform vec2 uTangent;
uniform vec2 uSize;
uniform vec2 uJitter;     // of the ray within its pixel, from its middle
uniform float uPixel;
uniform int uMaxCrossings;
uniform float uTube;      // sinh^2 of the radius of the edges
uniform float uFog;       // 1 / distance at which things fade
uniform float uMirror;    // share of the light that the wall reflects
uniform int uGrid;        // whether the wall shows its own geometry beyond its triangles
uniform int uColourBy;    // wall: 0 truncation triangle, 1 boundary component
uniform vec3 uPalette[48];  // as many as kColourCount of embedding/colour.hpp
uniform vec3 uFogColour;
uniform vec3 uSingular;   // the colour of singular edges
out vec4 colour;

const int kNothing = 0, kWall = 1, kEdge = 2;
const int kMaxMirrors = 4;

ivec2 gFirst;
vec4 texel(int i) { return texelFetch(uTetrahedra, gFirst + ivec2(i, 0), 0); }
void stand(int t) { gFirst = ivec2((t % uPerRow) * kTexels, t / uPerRow); }
float product(vec4 a, vec4 b) { return dot(a.xyz, b.xyz) - a.w * b.w; }
float arsinh(float x) { return sign(x) * log(abs(x) + sqrt(x * x + 1.0)); }

struct Hit {
  int kind;         // kNothing, kWall, kEdge
  int number;       // vertex or edge of the tetrahedron
  int tetrahedron;
  int crossings;
  float along;      // distance from the camera
  vec4 x, u;        // point and direction there
};

/// The two faces that meet in edge e: those opposite the vertices that are not its ends.
ivec2 facesAt(int e) {
  return e == 0 ? ivec2(2, 3) : e == 1 ? ivec2(1, 3) : e == 2 ? ivec2(1, 2)
       : e == 3 ? ivec2(0, 3) : e == 4 ? ivec2(0, 2) : ivec2(0, 1);
}
float cosineAt(int e) { return texel(26 + e / 4)[e & 3]; }

/// Where the geodesic meets the tube around the edge of two faces: tanh s, or 2. With a = <n_k, .>,
/// b = <n_l, .> the distance d from the edge has sinh^2 d = (a^2 + b^2 - 2 g a b) / (1 - g^2).
///   x, u   <n_k, .> and <n_l, .> of the point and the direction
///   scale  1 / (1 - g^2)
float meetTube(vec2 x, vec2 u, float g, float scale) {
  vec2 gu = u - g * u.yx;
  float xx = scale * dot(x, x - g * x.yx) - uTube;
  float xu = scale * dot(x, gu);
  float uu = scale * dot(u, gu) + uTube;
  // uu t^2 + 2 xu t + xx = 0, entered where it falls
  float discriminant = xu * xu - uu * xx;
  float t = xx / (sqrt(max(discriminant, 0.0)) - xu);
  return discriminant > 0.0 && xx > 0.0 && xu < 0.0 ? t : 2.0;
}

#if kKinds
/// Where the geodesic goes into the horoball <v, x> >= -1: tanh s, or 2. With a = <v, x> and
/// b = <v, u> that is a + b t = -sqrt(1 - t^2).
float meetHorosphere(float a, float b) {
  float discriminant = 1.0 + b * b - a * a;
  float t = (a * a - 1.0) / (sqrt(max(discriminant, 0.0)) - a * b);
  return b > 0.0 && discriminant > 0.0 ? max(t, 0.0) : 2.0;
}
#endif
/// The vector of a wall of the current tetrahedron, its time negated.
vec4 wallVector(int wall) {
#if kKinds == 2
  if (wall > 3) {
    ivec2 ends = facesAt(9 - wall);  // those of an edge are the faces at the opposite one
    return -texel(32 + (wall - 4) / 4)[wall & 3] * (texel(4 + ends.x) + texel(4 + ends.y));
  }
#endif
  return texel(4 + wall);
}
/// The unit normal of a wall of the current tetrahedron at a point x.
vec4 wallNormal(int wall, vec4 x) {
  vec4 normal = wallVector(wall) * vec4(1, 1, 1, -1);
#if kKinds == 2
  if (wall > 3) return normal - x;
#endif
#if kKinds
  if (texel(34)[wall] == 0.0) normal -= x;
#endif
  return normal;
}

/// Takes a thing that is met earlier than all before.
void first(float t, int kind, int number, inout float reach, inout ivec2 met) {
  if (t < reach) {
    reach = t;
    met = ivec2(kind, number);
  }
}

#if kKinds == 2
/// Takes edge e: the tube around it, or, if it is parabolic, its wall.
///   x, u, g, scale  as in meetTube
///   v               sums of the products of the point and the direction with the ends
void firstOfEdge(int e, vec2 x, vec2 u, float g, float scale, vec2 v, inout float reach,
                 inout ivec2 met) {
  if (scale < 0.0) first(meetHorosphere(-scale * v.x, -scale * v.y), kWall, 4 + e, reach, met);
  else first(meetTube(x, u, g, scale), kEdge, e, reach, met);
}
#endif

/// Follows the geodesic until it meets something. `from`: the face that it came in by, or -1. There is
/// no trigonometry on the way: the distance is half the logarithm of a product.
void trace(inout Hit hit, inout int from) {
  hit.kind = kNothing;
  float far = 1.0, sight = uOutput == kIdentities ? 6.0 : 2.6;
  float farthest = exp(min(2.0 * sight / uFog, 80.0) - 2.0 * hit.along);  // e^2s of the way
  ivec2 met = ivec2(kNothing, -1);
  for (; hit.crossings <= uMaxCrossings; ++hit.crossings) {
    stand(hit.tetrahedron);
    mat4 n = mat4(texel(0), texel(1), texel(2), texel(3));
    vec4 fx = hit.x * n, fu = hit.u * n;
    // Faces behind, and the one that it came in by, are met nowhere.
    vec4 ahead = mix(vec4(2.0), max(-fx / max(fu, 1e-20), 0.0), greaterThan(fu, vec4(0.0)));
    if (from >= 0) ahead[from] = 2.0;
    float reach = 1.0;
    met = ivec2(kNothing, -1);
    for (int f = 0; f < 4; ++f) first(ahead[f], kNothing, f, reach, met);
    n = mat4(texel(4), texel(5), texel(6), texel(7));
    vec4 vx = hit.x * n, vu = hit.u * n;
    ahead = mix(vec4(2.0), max(-vx / max(vu, 1e-20), 0.0), greaterThan(vu, vec4(0.0)));
#if kKinds
    vec4 kind = texel(34);
    for (int v = 0; v < 4; ++v)
      ahead[v] = kind[v] > 0.0 ? ahead[v] : kind[v] < 0.0 ? 2.0 : meetHorosphere(vx[v], vu[v]);
#endif
    for (int v = 0; v < 4; ++v) first(ahead[v], kWall, v, reach, met);
    vec4 g = texel(26), scale = texel(32);
#if kKinds == 2
#define sumsAt(i, j) vec2(vx[i] + vx[j], vu[i] + vu[j])
    firstOfEdge(0, fx.zw, fu.zw, g.x, scale.x, sumsAt(0, 1), reach, met);
    firstOfEdge(1, fx.yw, fu.yw, g.y, scale.y, sumsAt(0, 2), reach, met);
    firstOfEdge(2, fx.yz, fu.yz, g.z, scale.z, sumsAt(0, 3), reach, met);
    firstOfEdge(3, fx.xw, fu.xw, g.w, scale.w, sumsAt(1, 2), reach, met);
    g = texel(27);
    scale = texel(33);
    firstOfEdge(4, fx.xz, fu.xz, g.x, scale.x, sumsAt(1, 3), reach, met);
    firstOfEdge(5, fx.xy, fu.xy, g.y, scale.y, sumsAt(2, 3), reach, met);
#else
    first(meetTube(fx.zw, fu.zw, g.x, scale.x), kEdge, 0, reach, met);
    first(meetTube(fx.yw, fu.yw, g.y, scale.y), kEdge, 1, reach, met);
    first(meetTube(fx.yz, fu.yz, g.z, scale.z), kEdge, 2, reach, met);
    first(meetTube(fx.xw, fu.xw, g.w, scale.w), kEdge, 3, reach, met);
    g = texel(27);
    scale = texel(33);
    first(meetTube(fx.xz, fu.xz, g.x, scale.x), kEdge, 4, reach, met);
    first(meetTube(fx.xy, fu.xy, g.y, scale.y), kEdge, 5, reach, met);
#endif
    if (met.y < 0) break;  // only by rounding
    reach = min(reach, 0.99999);
    float c = inversesqrt(1.0 - reach * reach), s = reach * c;
    vec4 x = c * hit.x + s * hit.u, u = s * hit.x + c * hit.u;
    far *= (1.0 + reach) / (1.0 - reach);
    if (met.x == kNothing) {
      int row = 8 + 4 * met.y;
      mat4 crossing = mat4(texel(row), texel(row + 1), texel(row + 2), texel(row + 3));
      x = x * crossing;
      u = u * crossing;
      from = int(texel(25)[met.y]);
      hit.tetrahedron = int(texel(24)[met.y]);
    }
    x *= inversesqrt(max(-product(x, x), 1e-12));
    u += product(u, x) * x;
    hit.x = x;
    hit.u = u * inversesqrt(max(product(u, u), 1e-12));
    if (met.x != kNothing || far > farthest) break;
  }
  hit.kind = met.x;
  hit.number = max(met.y, 0);
  hit.along += 0.5 * log(far);
}

vec3 paletteOf(int i) { return uPalette[i % 48]; }

/// The hyperbolic size of a pixel on the wall, where it is longest.
float pixelOnWall(Hit hit) {
  float incidence = max(abs(dot(wallVector(hit.number), hit.u)), 0.06);
  return uPixel * sinh(min(hit.along, 12.0)) / incidence;
}
vec3 discsAt(Hit hit, out int disc) {
  return discColour(int(texel(31)[hit.number]), hit.x, pixelOnWall(hit), disc);
}

/// The wall with its own geometry: the truncation triangles that tile it, and inside each the
/// curves at equal distance from its sides.
vec3 wallColour(Hit hit) {
  float pixel = pixelOnWall(hit);
  float side = 1e9;
  for (int f = 0; f < 4; ++f)
    if (f != hit.number) side = min(side, -dot(texel(f), hit.x));
#if kKinds == 2
  // Where an edge is parabolic, its wall is a side; its own sides are two faces and two truncations.
  if (hit.number > 3) {
    ivec2 faces = facesAt(hit.number - 4), ends = facesAt(9 - hit.number);
    side = min(min(-dot(texel(faces.x), hit.x), -dot(texel(faces.y), hit.x)),
               min(-dot(texel(4 + ends.x), hit.x), -dot(texel(4 + ends.y), hit.x)));
  } else {
    for (int e = 0; e < 6; ++e) {
      ivec2 ends = facesAt(5 - e);
      if (texel(32 + e / 4)[e & 3] < 0.0 && (ends.x == hit.number || ends.y == hit.number))
        side = min(side, sinh(log(max(-dot(wallVector(4 + e), hit.x), 1.0))));
    }
  }
#endif
  side = arsinh(side);
  int index = uColourBy == 0 ? 4 * hit.tetrahedron + hit.number
                             : int(texel(30)[hit.number & 3]);
#if kKinds == 2
  // Colours of annular cusps are counted from the last one on.
  if (hit.number > 3)
    index = 47 - (uColourBy == 0 ? 6 * hit.tetrahedron + hit.number - 4
                                 : int(texel(28 + (hit.number - 4) / 4)[hit.number & 3])) % 48;
#endif
  vec3 base = mix(paletteOf(index), vec3(0.93, 0.91, 0.86), uColourBy == 0 ? 0.22 : 0.15);
  float blur = smoothstep(0.35, 0.08, pixel);  // what is finer than pixels becomes its mean
  int disc;
  if (uDiscsOn == 1 && hit.number < 4) base = discsAt(hit, disc);
  else if (uGrid == 1) {
    float ring = side / 0.12;
    float away = abs(ring - round(ring)) * 0.12;
    float line = (1.0 - smoothstep(0.003, 0.003 + 1.2 * pixel, away)) * step(0.5, ring);
    base *= 1.0 - 0.22 * line * smoothstep(0.06, 0.02, pixel);
    base *= 0.90 + 0.10 * smoothstep(0.0, 0.3, side);
  }
  float line = 1.0 - smoothstep(0.008, 0.008 + 1.2 * pixel, side);
  return base * (1.0 - 0.62 * line * blur);
}

/// x^32
float power(float x) {
  x *= x;
  x *= x;
  x *= x;
  x *= x;
  return x * x;
}

vec3 edgeColour(Hit hit, out float facing) {
  ivec2 k = facesAt(hit.number);
  vec4 n = texel(k.x), m = texel(k.y);
  float g = cosineAt(hit.number), scale = 1.0 / (1.0 - g * g);
  float a = dot(n, hit.x), b = dot(m, hit.x);
  vec4 flip = vec4(1, 1, 1, -1);
  // The part of x across the edge; the gradient of the distance is tangent at x.
  vec4 across = scale * ((a - g * b) * n + (b - g * a) * m) * flip;
  vec4 gradient = across + product(across, hit.x) * hit.x;
  gradient *= inversesqrt(max(product(gradient, gradient), 1e-12));
  facing = clamp(-product(gradient, hit.u), 0.0, 1.0);
  int edge = int(texel(28 + hit.number / 4)[hit.number & 3]);
  if (texel(35 + hit.number / 4)[hit.number & 3] > 0.5) return uSingular;
  return mix(paletteOf(edge + 5), vec3(0.1, 0.12, 0.2), 0.25);
}

void main() {
  vec2 ndc = 2.0 * (gl_FragCoord.xy + uJitter) / uSize - 1.0;
  vec3 ray = normalize(vec3(ndc * uTangent, 1.0));
  Hit hit;
  hit.tetrahedron = uStart;
  hit.crossings = 0;
  hit.number = 0;
  hit.along = 0.0;
  hit.x = uFrame[3];
  hit.u = uFrame * vec4(ray, 0.0);
  int from = -1;
  vec3 sum = vec3(0.0);
  float weight = 1.0;
  for (int mirror = 0; mirror <= kMaxMirrors; ++mirror) {
    trace(hit, from);
    if (uOutput == kIdentities) {
      int disc = 0;
      stand(hit.tetrahedron);
      if (uDiscsOn == 1 && hit.kind == kWall && hit.number < 4) discsAt(hit, disc);
      colour = vec4(float(hit.kind), float(hit.tetrahedron & 255),
                    float(hit.number) + discIdentity(disc),
                    255.0 - float(min(hit.crossings, 200))) / 255.0;
      return;
    }
    float faded = hit.along * uFog;  // to the power 2 1/4
    float clear = hit.kind == kNothing ? 0.0 : exp(-faded * faded * sqrt(sqrt(faded)));
    vec3 seen = vec3(0.0);
    float share = 1.0;
    if (hit.kind == kWall) {
      stand(hit.tetrahedron);
      float facing = abs(product(wallNormal(hit.number, hit.x), hit.u));
      seen = wallColour(hit) * (0.42 + 0.58 * facing);
      if (uMirror > 0.0) share = 1.0 - (uMirror + (1.0 - uMirror) * pow(1.0 - facing, 5.0) * 0.5);
    } else if (hit.kind == kEdge) {
      float facing;
      stand(hit.tetrahedron);
      seen = edgeColour(hit, facing) * (0.25 + 0.85 * facing) + 0.30 * power(facing);
    }
    sum += weight * (share * clear * seen + (1.0 - clear) * uFogColour);
    weight *= clear * (1.0 - share);
    if (hit.kind != kWall || weight < 0.02) break;
    vec4 normal = wallNormal(hit.number, hit.x);
    hit.u -= 2.0 * product(hit.u, normal) * normal;
    from = -1;
  }
  colour = finite(toDisplay(sum));
}
