// The colours of the desktop viewer.
// kDiscs, whether discs are drawn, is defined in front of it.
uniform bool uIdentities;
uniform float uAlpha;        // of what is no border
out vec4 colour;

#if kDiscs
vec3 discsAt(Meeting met, out int disc) {
  float scale;
  vec4 x = onHyperboloid(met, scale);
  float pixel = scale * sqrt(max(dot(met.right, met.right), dot(met.up, met.up)));
  return discColour(int(vAbout.w), x, pixel, disc);
}
#endif

void main() {
  vec3 ray = rayThroughPixel(gl_FragCoord.xy);
  Meeting met;
  if (!meet(ray, met)) discard;
  gl_FragDepth = depthOf(met.along * vEye.w * dot(ray, uAxes[2]));
  int disc = 0;
  vec3 own = vColour.rgb;
#if kDiscs
  if (onTruncation()) own = discsAt(met, disc);
#endif
  if (uIdentities) {
    int number = int(vColour.w) + 1;
    colour = vec4(float(number & 255), float(number >> 8),
                  float(wallNumber() + 1) + discIdentity(disc), 255.0) / 255.0;
    return;
  }
  vec3 normal = dot(met.normal, ray) < 0.0 ? met.normal : -met.normal;
  vec3 shown = lit(own, normal, ray);
  shown = mix(shown, 0.22 * own, met.border);
  float drawn = met.border;
#if kEdges
  shown = mix(shown, met.edge.rgb, met.edge.a);
  drawn = max(drawn, met.edge.a);
#endif
  colour = vec4(shown, mix(uAlpha, 1.0, drawn));
}
