// The light of the outside view, after its camera.

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
