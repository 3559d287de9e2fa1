// The colours of faces in a page. kDiscs, whether discs are drawn, is defined in front of it.
uniform sampler2D uPlaces;  // five texels for each cell: from its frame to that of its tetrahedron
uniform vec3 uKey;          // unit, towards the light
out vec4 colour;

#if kDiscs
vec3 discsAt(Meeting met, vec3 ray, out int disc) {
  int first = 5 * int(vColour.w);
  vec4 column[5];
  for (int k = 0; k < 5; ++k)
    column[k] = texelFetch(uPlaces, ivec2((first + k) % 2048, (first + k) / 2048), 0);
  vec4 x = column[0] * met.u.x + column[1] * met.u.y + column[2] * met.u.z +
           column[3] * dot(met.u, met.u) + column[4];
  float scale = inversesqrt(max(-discProduct(x, x), 1e-30));
  float incidence = max(abs(dot(met.normal, ray)), 0.06);
  return discColour(int(vAbout.w), x * scale, met.along * uPixel * scale / incidence, disc);
}
#endif

/// Soft light: a key over the camera's shoulder, so that no view is dark, the sky above and a little
/// from the ground.
vec3 lit(vec3 base, vec3 normal, vec3 view) {
  float diffuse = max(dot(normal, uKey), 0.0);
  vec3 ambient = vec3(0.45, 0.455, 0.49) + vec3(0.05, 0.085, 0.11) * normal.z;
  vec3 halfway = normalize(uKey - view);
  float gloss = max(dot(normal, halfway), 0.0);
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  gloss *= 0.12 * gloss * gloss;  // to the 48th
  return base * (ambient + 0.62 * diffuse) + gloss;
}

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
