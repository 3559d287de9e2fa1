// The discs of arcs on the truncations, after common.glsl. Two texels each, centre; colour and
// extent, 4 sinh^2 of half the radius, which is negative behind the last disc of a tile.
uniform sampler2D uDiscs;
uniform int uDiscsOn;
uniform vec3 uBareWall;   // between discs
const int kDiscTexelsPerRow = 2048;

vec4 discTexel(int i) {
  return texelFetch(uDiscs, ivec2(i % kDiscTexelsPerRow, i / kDiscTexelsPerRow), 0);
}
float discProduct(vec4 a, vec4 b) { return dot(a.xyz, b.xyz) - a.w * b.w; }

/// The discs of a tile at a point x of the hyperboloid, in its tetrahedron's coordinates. `number`:
/// of the disc that holds x, from 1, or 0.
///   first   texel where the discs of the tile begin
///   pixel   hyperbolic size of one
vec3 discColour(int first, vec4 x, float pixel, out int number) {
  vec3 result = uBareWall;
  number = 0;
  for (int i = first;; i += 2) {
    vec4 about = discTexel(i + 1);
    if (about.w < 0.0) break;
    vec4 away = x - discTexel(i);
    float radius = sqrt(about.w), inside = radius - sqrt(max(discProduct(away, away), 0.0));
    // Discs finer than pixels have the share of it that they cover.
    float share = clamp(0.5 + inside / pixel, 0.0, 1.0) * min(1.0, 2.0 * radius / pixel);
    result = mix(result, about.rgb, share);
    if (inside > 0.0) {
      number = 1 + (i - first) / 2;
      if (share == 1.0) break;
    }
  }
  return result;
}

/// In kIdentities, beside a wall's number: 1 to 14 for the first discs of its tile, 15 for others.
float discIdentity(int number) { return 16.0 * float(min(number, 15)); }
