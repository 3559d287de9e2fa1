// The colours of faces in a page. kDiscs, whether discs are drawn, is defined in front of it.
uniform float uAlpha;       // of what is no border
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
  vec3 normal = dot(met.normal, ray) < 0.0 ? met.normal : -met.normal;
  vec3 shade = lit(base, normal, ray) * (1.0 - 0.96 * met.border);
  float drawn = met.border;
#if kEdges
  shade = mix(shade, met.edge.rgb, met.edge.a);
  drawn = max(drawn, met.edge.a);
#endif
  colour = finite(throughGlass(toDisplay(shade), ray));
  colour.a *= mix(uAlpha, 1.0, drawn);
}
