// One corner of the polygon around the place of a face on the picture, and the record of the face
// for its pixels; face_set.cpp and faces.js write records. All half-spaces are
//   f(u) = a |u|^2 + b.u + c - (d.u)^2 <= 0
// in the frame of the cell, where its ball is the unit ball, and |grad f| = 1 where f = 0 and d = 0.
// Defined in front of this text are kKind, 0 a truncation, 1 a face, 2 a cut, 3 the wall of a
// parabolic edge; kBounds, the number of half-spaces that bound it, and kBends, of how many d is
// given; and a camera stands there, which has uEye and uPixel. d is 0 but for horospheres of the
// Klein ball; it is given, if at all, of the own half-space of kinds 0 and 3, and of the bounds that
// may be horospheres: all but the first 3, or 4 of kinds 2 and 3. Where there are more bounds than
// shaders hand on (kFetched), the pixels read them for themselves.
uniform sampler2D uFaces;
uniform float uShrink;       // of cells towards their middles; 1: not at all
layout(location = 0) in vec3 aCorner;  // x, y in [-1, 1]; the texel where the record begins

flat out vec4 vOwn;          // half-space of the face: b, a
flat out vec4 vAbout;        // its c; number of the wall; 1 if another cell has it too; first disc
flat out vec4 vEye;          // the eye in the cell's frame; the cell's radius in the model
flat out vec4 vCentre;       // of the cell, in the model; its radius in pixels
flat out vec4 vColour;       // colour; number of the cell
#define kFetched (kBounds > 9)
#if kFetched
flat out float vRecord;      // the texel where the record begins
#else
flat out vec4 vBound[kBounds];                 // half-spaces that bound the face: b, a
flat out vec4 vBoundConstant[(kBounds + 3) / 4];  // their c
#if kBends > 0
flat out vec4 vBend[kBends];                   // d
#endif
#endif

const int kRecordTexelsPerRow = 2048;
vec4 record(int i) {
  int at = int(aCorner.z) + i;
  return texelFetch(uFaces, ivec2(at % kRecordTexelsPerRow, at / kRecordTexelsPerRow), 0);
}

void main() {
  vOwn = record(0);
  vAbout = record(1);
  vec4 ball = record(2);
  ball.w *= uShrink;
  vec3 eye = uEye - ball.xyz;
  vEye = vec4(eye / ball.w, ball.w);
  vCentre = vec4(ball.xyz, ball.w / (max(length(eye), ball.w) * uPixel));
  vColour = record(3);
#if kFetched
  vRecord = aCorner.z;
#else
  for (int i = 0; i < kBounds; ++i) vBound[i] = record(4 + i);
  for (int i = 0; i < (kBounds + 3) / 4; ++i) vBoundConstant[i] = record(4 + kBounds + i);
#if kBends > 0
  for (int i = 0; i < kBends; ++i) vBend[i] = record(4 + kBounds + (kBounds + 3) / 4 + i);
#endif
#endif
#ifdef kHandOn
  handOn();
#endif
  gl_Position = vec4(aCorner.xy, 0.0, 1.0);
}
