#include "viewer/opencsg/detail/shaders.hpp"

namespace tripus::viewer {

// GLSL 1.20: OpenCSG draws depths by the fixed functions, and only ftransform() promises the very
// same depths here.
const std::string_view kWallVertexShader = R"(#version 120
varying vec3 position;
void main() {
  position = gl_Vertex.xyz;
  gl_Position = ftransform();
}
)";

const std::string_view kWallFragmentShader = R"(#version 120
const int kMost = 16;          // kMostHalfSpaces
uniform vec4 linear[kMost];    // b, c of the half-spaces a |p|^2 + b.p + c <= 0
uniform float square[kMost];   // a
uniform float kind[kMost];     // 0 face, 1 truncation, 2 side of the model, 3 cut-away
uniform int count;
uniform int own;
uniform bool discarding;       // whether this shader does the CSG itself
uniform float pixel;           // size of one
uniform float slack;           // farthest that the mesh of a wall leaves it
uniform bool plain;            // whether to show `colour` as it is
uniform vec3 colour;
uniform vec3 eye;              // in the local frame
uniform vec3 key_light;        // unit, towards the light
uniform float line_width;      // pixels
uniform float first_disc;      // texel; negative: none lie on this wall
uniform sampler2D discs;
uniform float disc_rows;
uniform vec4 to_tetrahedron[5];
uniform vec3 bare;             // between discs
varying vec3 position;

float product(vec4 a, vec4 b) { return dot(a.xyz, b.xyz) - a.w * b.w; }

vec4 disc_texel(float i) {
  const float row = 2048.0;    // kDiscTexelsPerRow
  float y = floor((i + 0.5) / row);
  return texture2D(discs, vec2((i - row * y + 0.5) / row, (y + 0.5) / disc_rows));
}

// The discs at a point x of the hyperboloid, and in `number` the one it lies in, from 1, or 0.
// pixel: the hyperbolic size of one
vec3 disc_colour(vec4 x, float pixel, out float number) {
  vec3 result = bare;
  number = 0.0;
  float i = first_disc;
  for (float n = 1.0;; n += 1.0) {
    vec4 about = disc_texel(i + 1.0);
    if (about.w < 0.0) break;
    vec4 away = x - disc_texel(i);
    float radius = sqrt(about.w), inside = radius - sqrt(max(product(away, away), 0.0));
    // Discs finer than pixels have the share of it that they cover.
    float share = clamp(0.5 + inside / pixel, 0.0, 1.0) * min(1.0, 2.0 * radius / pixel);
    result = mix(result, about.rgb, share);
    if (inside > 0.0) {
      number = n;
      if (share == 1.0) break;
    }
    i += 2.0;
  }
  return result;
}

void main() {
  // From the mesh to the true wall: along the ray, so that all meshes of one wall give one point; where
  // the ray grazes the wall, along the gradient (of length 1 there).
  vec3 p = position;
  vec3 ray = normalize(position - eye);
  float f_own = square[own] * dot(p, p) + dot(linear[own].xyz, p) + linear[own].w;
  float f_now = f_own;
  for (int step = 0; step < 2; ++step) {
    vec3 gradient = 2.0 * square[own] * p + linear[own].xyz;
    float along = dot(gradient, ray);
    p -= abs(along) > 0.05 ? ray * (f_now / along) : gradient * f_now;
    f_now = square[own] * dot(p, p) + dot(linear[own].xyz, p) + linear[own].w;
  }
  vec3 normal = normalize(2.0 * square[own] * p + linear[own].xyz);

  // Distances in pixels to the other walls: where they meet this one are the edges of the cell.
  float ink = 0.0;
  // The sides and the base that close a mesh are no wall.
  bool outside = discarding && abs(f_own) > slack;
  for (int i = 0; i < kMost; ++i) {
    if (i >= count) break;
    float f = square[i] * dot(p, p) + dot(linear[i].xyz, p) + linear[i].w;
    vec2 slope = vec2(dFdx(f), dFdy(f));
    float pixels = -f / max(length(slope), 1e-12);
    if (i == own) continue;
    outside = outside || f > (discarding ? 0.02 : 0.6) * pixel;
    if (kind[i] == 2.0) continue;
    bool edge = kind[own] == 0.0 && kind[i] == 0.0;
    float width = edge ? line_width : 0.5 * line_width;
    float strength = edge ? 0.85 : 0.55;
    ink = max(ink, strength * (1.0 - smoothstep(width - 0.6, width + 0.6, pixels)));
  }
  vec3 own_colour = colour;
  if (first_disc >= 0.0) {
    vec4 x = to_tetrahedron[0] * p.x + to_tetrahedron[1] * p.y + to_tetrahedron[2] * p.z +
             to_tetrahedron[3] * dot(p, p) + to_tetrahedron[4];
    x *= inversesqrt(max(-product(x, x), 1e-30));
    vec4 right = dFdx(x), up = dFdy(x);
    float size = sqrt(max(max(product(right, right), product(up, up)), 1e-20));
    float disc;
    vec3 shown = disc_colour(x, size, disc);
    // In a plain picture the disc is told, from 1 to 14, or 15: in the upper half of blue.
    own_colour = plain ? colour + vec3(0.0, 0.0, min(disc, 15.0) * 16.0 / 255.0) : shown;
  }
  // Cells along one geodesic plane share the surface of their truncations: that a pixel has our depth
  // does not make it ours.
  // A little beyond the edge is ours, or there were slits between cells.
  if (outside) discard;
  if (plain) {
    gl_FragColor = vec4(own_colour, 1.0);
    return;
  }
  vec3 view = normalize(eye - p);
  if (discarding && dot(normal, view) < 0.0) normal = -normal;
  float key = max(dot(normal, key_light), 0.0);
  float sky = 0.5 + 0.5 * normal.z;
  float shine = pow(max(dot(normal, normalize(key_light + view)), 0.0), 40.0);
  float rim = pow(1.0 - max(dot(normal, view), 0.0), 3.0);
  vec3 albedo = own_colour * own_colour;  // about from sRGB to light
  vec3 light = albedo * (0.75 * key + mix(vec3(0.26, 0.24, 0.23), vec3(0.46, 0.49, 0.54), sky));
  light += vec3(0.10 * shine) + vec3(0.05, 0.055, 0.06) * rim;
  vec3 shown = sqrt(clamp(light, 0.0, 1.0));
  gl_FragColor = vec4(mix(shown, 0.22 * own_colour, ink), 1.0);
}
)";

}  // namespace tripus::viewer
