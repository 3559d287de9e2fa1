// The colours of tubes of the desktop viewer, blended at their rims.
out vec4 colour;

void main() {
  vec3 ray = rayThroughPixel(gl_FragCoord.xy);
  TubeMeeting met;
  if (!meetTube(ray, met)) discard;
  gl_FragDepth = depthOf(met.along * vEye.w * dot(ray, uAxes[2]));
  colour = vec4(lit(vColour, met.normal, ray), met.coverage);
}
