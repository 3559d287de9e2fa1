// The background of the ball: strips from the lower end of the picture to the upper one, behind
// everything. After a camera; kStrips is defined in front of it.
uniform vec3 uHigh, uLow;  // background above and below
out vec3 vSky;

void main() {
  float height = float(gl_VertexID >> 1) / float(kStrips);
  vSky = uOutput == kIdentities ? vec3(0.0) : toDisplay(mix(uLow, uHigh, smoothstep(0.0, 1.0, height)));
  gl_Position = vec4((gl_VertexID & 1) == 0 ? -1.0 : 1.0, 2.0 * height - 1.0, 1.0, 1.0);
}
