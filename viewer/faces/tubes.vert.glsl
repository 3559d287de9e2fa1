// One corner of the polygon around the place of a piece of a tube on the picture, and the record of
// the piece for its pixels; tubes.cpp and tubes.js write records. Polynomials a |u|^2 + b.u + c are
// in the frame of the piece, where its ball is the unit ball. After a camera, which has uEye and
// uPixel.
uniform sampler2D uTubes;
uniform float uThin;         // half the width in pixels of what is never thinner
layout(location = 0) in vec3 aCorner;  // x, y in [-1, 1]; the texel where the record begins

flat out vec4 vAcross[2];    // what the products of a point with two normals of the axis are: b, a
flat out vec4 vFactor;       // the factor of the model that they have; its square in the Klein ball
flat out vec4 vEnds[2];      // half-spaces that end the piece
flat out vec4 vConstants;    // c of the first three and of one end
flat out vec4 vAbout;        // c of the other end; sinh^2 of the tube's radius; its least in pixels
flat out vec4 vEye;          // the eye in the frame of the piece; the radius of its ball
flat out vec3 vCentre;       // of the ball, in the model
flat out vec3 vColour;

const int kTubeTexelsPerRow = 2048;
vec4 record(int i) {
  int at = int(aCorner.z) + i;
  return texelFetch(uTubes, ivec2(at % kTubeTexelsPerRow, at / kTubeTexelsPerRow), 0);
}

void main() {
  vAcross[0] = record(0);
  vAcross[1] = record(1);
  vFactor = record(2);
  vEnds[0] = record(3);
  vEnds[1] = record(4);
  vConstants = record(5);
  vAbout = record(6);
  vec4 ball = record(7);
  vEye = vec4((uEye - ball.xyz) / ball.w, ball.w);
  vAbout.z *= min(uThin, 0.15 / (length(vEye.xyz) * uPixel));
  vCentre = ball.xyz;
  vColour = record(8).rgb;
  gl_Position = vec4(aCorner.xy, 0.0, 1.0);
}
