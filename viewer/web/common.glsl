#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;

// Picture or proof: in kIdentities each pixel says what it shows, for the tests.
const int kColours = 0;
const int kIdentities = 1;
uniform int uOutput;

/// About from light to sRGB; linearColour() of palette.js goes back.
vec3 toDisplay(vec3 linear) { return sqrt(clamp(linear, 0.0, 1.0)); }

/// The colour of a pixel; one that is not a number becomes magenta and half transparent, which
/// nothing else is, so that it shows and that a test finds it.
vec4 finite(vec3 colour) {
  bool good = abs(colour.r) + abs(colour.g) + abs(colour.b) < 1e9;
  return good ? vec4(colour, 1.0) : vec4(1.0, 0.0, 1.0, 0.5);
}
