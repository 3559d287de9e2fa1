// The colours of tubes in a page, blended at their rims.
out vec4 colour;

void main() {
  vec3 ray = rayThroughPixel(gl_FragCoord.xy);
  TubeMeeting met;
  if (!meetTube(ray, met)) discard;
  gl_FragDepth = depthOf(met.along * vEye.w);
  colour = finite(throughGlass(toDisplay(lit(vColour, met.normal, ray)), ray));
  colour.a = met.coverage;
}
