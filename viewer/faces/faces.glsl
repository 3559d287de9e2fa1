// Where the ray of a pixel meets a face: faces.vert.glsl has its numbers. After a camera, which
// has uEye, uAxes (right, up, forward) and uPixel (the angle of a pixel), and before a main() that
// gives the colour; with discs also after discs.glsl. Defined in front of it, and no uniforms, as
// renderers in software compute branches that are not taken: kKind; kBounds; kBends; kSides, 1 for the outer side
// of faces alone, 2 for both; kModel, 0 upper half-space, 1 Poincare ball, 2 Klein ball; kCut,
// whether uCut is heeded; kDiscs, whether discs are drawn; kEdges, whether edges have the colours of
// their classes.
uniform float uShrink;       // of cells towards their middles; 1: not at all
uniform float uCut;          // what lies beyond x = uCut in the model is not drawn
uniform vec2 uLine;          // half the width of edges and of other borders, in pixels
#if kEdges
uniform vec3 uPalette[48];   // as many as kColourCount of embedding/colour.hpp
#endif

flat in vec4 vOwn;
flat in vec4 vAbout;
flat in vec4 vEye;
flat in vec4 vCentre;
flat in vec4 vColour;
// Those of kinds 0 and 3 have a d of their own half-space, in front of the others.
#define kOwnBend (kKind == 0 || kKind == 3)
#define kFlatBounds (kKind < 2 ? 3 : 4)
#define kFetched (kBounds > 9)
#if kFetched
uniform sampler2D uFaces;
flat in float vRecord;
vec4 fetched(int i) {
  int at = int(vRecord) + i;
  return texelFetch(uFaces, ivec2(at % 2048, at / 2048), 0);
}
#define boundOf(i) fetched(4 + (i))
#define constantOf(i) fetched(4 + kBounds + (i) / 4)[(i) % 4]
#define storedBend(i) fetched(4 + kBounds + (kBounds + 3) / 4 + (i)).xyz
#else
flat in vec4 vBound[kBounds];
flat in vec4 vBoundConstant[(kBounds + 3) / 4];
#if kBends > 0
flat in vec4 vBend[kBends];
#endif
#define boundOf(i) vBound[i]
#define constantOf(i) vBoundConstant[(i) / 4][(i) % 4]
#define storedBend(i) vBend[i].xyz
#endif
#if kBends > 0
#define kBendOf(i) storedBend(i)
#else
#define kBendOf(i) vec3(0.0)
#endif

/// A face reaches beyond its borders by this part of a pixel, and this length, so that rays do not
/// slip between two faces by rounding.
const float kOverlapPixels = 0.01, kOverlap = 1e-5;

struct Meeting {
  vec3 u;        // in the frame of the cell
  float along;   // from the eye, in radii of the cell
  vec3 normal;   // outward, of length 1
  vec3 right, up;  // what a step of one pixel moves u by
  float border;  // 1 on a border of the face, and less across a pixel beside it
#if kEdges
  vec4 edge;     // the colour of the edge there, and how much of it is seen
#endif
};

int wallNumber() { return int(vAbout.y); }
bool onTruncation() { return vAbout.y > 3.5 && vAbout.y < 7.5; }

/// How dark a line is, so many pixels beyond its rim.
float lineAt(float beyond) {
  float t = clamp(0.5 - 0.8333333 * beyond, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Beyond f <= 0 at a point the face ends. Updates whether the point is `inside`, and how many
/// pixels it is from the nearest such border.
///   square, right, up  |u|^2, and what a step of one pixel changes it by
void bounded(vec4 bound, float constant, vec3 bend, Meeting met, float square, float right,
             float up, inout bool inside, inout float pixels) {
  float f = bound.w * square + dot(bound.xyz, met.u) + constant;
  vec2 slope = vec2(bound.w * right + dot(bound.xyz, met.right),
                    bound.w * up + dot(bound.xyz, met.up));
#if kBends > 0
  float bent = dot(bend, met.u);
  f -= bent * bent;
  slope -= 2.0 * bent * vec2(dot(bend, met.right), dot(bend, met.up));
#endif
  float away = -f * inversesqrt(max(dot(slope, slope), 1e-30));
  // Written so that what is no number is outside.
  inside = inside && (away >= -kOverlapPixels || f <= kOverlap);
  pixels = min(pixels, away);
}

/// Whether the point at `along` on the ray, where it meets the sphere, lies in the face.
///   towards  the product of the ray and the normal there
bool holds(vec3 ray, vec3 u, float along, float towards, out Meeting met) {
  met.u = u;
  met.along = along;
  met.normal = 2.0 * vOwn.w * u + vOwn.xyz;
#if kBends > 0 && kOwnBend
  met.normal -= 2.0 * dot(kBendOf(0), u) * kBendOf(0);
  float steep = inversesqrt(max(dot(met.normal, met.normal), 1e-30));
  met.normal *= steep;
  towards *= steep;
#endif
  vec3 p = vCentre.xyz + vEye.w / uShrink * u;
  bool inside = along > 0.0;
#if kCut
  inside = inside && p.x <= uCut;
#endif
  // Spheres go on beyond the model's boundary, where everything has a mirror image.
#if kModel == 0
  inside = inside && p.z >= 0.0;
#elif kModel == 1
  inside = inside && dot(p, p) <= 1.0;
#endif

  float size = uPixel * along * dot(ray, uAxes[2]);
  float slant = towards < 0.0 ? min(towards, -0.004) : max(towards, 0.004);
  vec3 away = ray * (size / slant);
  met.right = size * uAxes[0] - away * dot(met.normal, uAxes[0]);
  met.up = size * uAxes[1] - away * dot(met.normal, uAxes[1]);
  float square = dot(u, u), right = 2.0 * dot(u, met.right), up = 2.0 * dot(u, met.up);
  vec3 edges = vec3(1e9);  // pixels to them
  bounded(boundOf(0), constantOf(0), vec3(0.0), met, square, right, up, inside, edges.x);
  bounded(boundOf(1), constantOf(1), vec3(0.0), met, square, right, up, inside, edges.y);
  bounded(boundOf(2), constantOf(2), vec3(0.0), met, square, right, up, inside, edges.z);
  float faces = min(edges.x, min(edges.y, edges.z)), others = 1e9;
#if kKind == 3
  bounded(boundOf(3), constantOf(3), vec3(0.0), met, square, right, up, inside, others);
#elif kKind == 0 || kBounds > 8
  for (int i = 3; i < kBounds; ++i) {
    vec3 bend = vec3(0.0);
#if kBends > 0
    if (i >= kFlatBounds) bend = storedBend((kOwnBend ? 1 : 0) + i - kFlatBounds);
#endif
    bounded(boundOf(i), constantOf(i), bend, met, square, right, up, inside, others);
  }
#elif kBounds == 6
  bounded(vBound[3], vBoundConstant[0].w, kBendOf(0), met, square, right, up, inside, others);
  bounded(vBound[4], vBoundConstant[1].x, kBendOf(1), met, square, right, up, inside, others);
  bounded(vBound[5], vBoundConstant[1].y, kBendOf(2), met, square, right, up, inside, others);
#elif kBounds == 8
  bounded(vBound[3], vBoundConstant[0].w, vec3(0.0), met, square, right, up, inside, others);
  bounded(vBound[4], vBoundConstant[1].x, kBendOf(0), met, square, right, up, inside, others);
  bounded(vBound[5], vBoundConstant[1].y, kBendOf(1), met, square, right, up, inside, others);
  bounded(vBound[6], vBoundConstant[1].z, kBendOf(2), met, square, right, up, inside, others);
  bounded(vBound[7], vBoundConstant[1].w, kBendOf(3), met, square, right, up, inside, others);
#endif
#if kCut
  others = min(others, (uCut - p.x) / max(vEye.w * length(vec2(met.right.x, met.up.x)), 1e-12));
#endif
  // Where two faces meet is an edge of the triangulation. Small cells have thin lines, or they
  // would be nothing but lines.
  vec2 widths = min(uLine, vec2(0.03, 0.015) * vCentre.w);
#if kEdges && kKind == 1
  int classes = int(constantOf(kBounds));  // behind those of the bounds
  int edge = edges.x == faces ? classes : edges.y == faces ? classes >> 6 : classes >> 12;
  float wide = min(2.5 * uLine.x, 0.05 * vCentre.w);
  met.edge = vec4(uPalette[edge & 63], lineAt(faces - wide));
  met.border = 0.55 * lineAt(others - widths.y);
#elif kEdges
  met.edge = vec4(0.0);
  met.border = 0.55 * lineAt(min(faces, others) - widths.y);
#elif kKind == 1
  met.border = max(0.85 * lineAt(faces - widths.x), 0.55 * lineAt(others - widths.y));
#else
  met.border = 0.55 * lineAt(min(faces, others) - widths.y);
#endif
  return inside;
}

/// Whether the ray meets the face, and where first.
bool meet(vec3 ray, out Meeting met) {
  float nearest = -dot(vEye.xyz, ray);
  vec3 o = vEye.xyz + nearest * ray;  // the point of the ray nearest to the cell's middle
  float a = vOwn.w, b = dot(vOwn.xyz, ray);
  float c = a * dot(o, o) + dot(vOwn.xyz, o) + vAbout.x;
#if kBends > 0 && kOwnBend
  float start = dot(kBendOf(0), o), step = dot(kBendOf(0), ray);
  a -= step * step;
  b -= 2.0 * start * step;
  c -= start * start;
#endif
  float discriminant = b * b - 4.0 * a * c;
  bool meets = discriminant >= 0.0;
  float root = sqrt(max(discriminant, 0.0));
  // The ray goes into the half-space where f falls, and out where it rises.
  float twice = abs(a) > 1e-9 ? 2.0 * a : 1e-9;
  float into = (b < 0.0 ? 2.0 * c : -b - root) / (b < 0.0 ? root - b : twice);
#if kSides == 1
  return holds(ray, o + into * ray, nearest + into, -root, met) && meets;
#else
  float away = (b > 0.0 ? -2.0 * c : root - b) / (b > 0.0 ? b + root : twice);
  // A face of two cells shows the one that is seen into.
  bool only = vAbout.z > 0.5;
  bool first = !only && into <= away;
  float near = first ? into : away, far = first ? away : into, sign = first ? -1.0 : 1.0;
  bool held = holds(ray, o + near * ray, nearest + near, sign * root, met);
  Meeting other;
  bool held_behind = holds(ray, o + far * ray, nearest + far, -sign * root, other);
  if (!held) met = other;
  return meets && (held || (held_behind && !only));
#endif
}

#if kDiscs
uniform sampler2D uPlaces;   // five texels for each cell: to_tetrahedron of scene.hpp

/// The point of the hyperboloid where the ray meets the face, in the frame of its tetrahedron.
///   scale  hyperbolic length there, where u moves by 1
vec4 onHyperboloid(Meeting met, out float scale) {
  int first = 5 * int(vColour.w);
  vec4 column[5];
  for (int k = 0; k < 5; ++k)
    column[k] = texelFetch(uPlaces, ivec2((first + k) % 2048, (first + k) / 2048), 0);
  vec4 x = column[0] * met.u.x + column[1] * met.u.y + column[2] * met.u.z +
           column[3] * dot(met.u, met.u) + column[4];
  scale = inversesqrt(max(-discProduct(x, x), 1e-30));
  return x * scale;
}
#endif
