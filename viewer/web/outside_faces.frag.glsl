// The colours of faces in a page. kDiscs, whether discs are drawn, is defined in front of it.
out vec4 colour;

#if kDiscs
vec3 discsAt(Meeting met, vec3 ray, out int disc) {
  float scale;
  vec4 x = onHyperboloid(met, scale);
  float incidence = max(abs(dot(met.normal, ray)), 0.06);
  return discColour(int(vAbout.w), x, met.along * uPixel * scale / incidence, disc);
}
#endif

void main() {
  vec3 ray = rayThroughPixel(gl_FragCoord.xy);
  Meeting met;
  if (!meet(ray, met)) discard;
  gl_FragDepth = depthOf(met.along * vEye.w);
  int disc = 0;
  vec3 base = vColour.rgb;
#if kDiscs
  if (onTruncation()) base = discsAt(met, ray, disc);
#endif
  if (uOutput == kIdentities) {
    int number = int(vColour.w);
    colour = vec4(float(number & 255), float(number >> 8),
                  float(wallNumber() + 1) + discIdentity(disc), 255.0) / 255.0;
    return;
  }
  vec3 shade = lit(base, met.normal, ray) * (1.0 - 0.96 * met.border);
  colour = finite(throughGlass(toDisplay(shade), ray));
}
