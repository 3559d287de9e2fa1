// The light of the desktop viewer, that of its OpenCSG renderer (opencsg/detail/shaders.cpp).
uniform vec3 uKeyLight;      // unit, towards the light

/// A surface of colour `own` (sRGB), seen along a ray; its normal turns towards the eye.
vec3 lit(vec3 own, vec3 normal, vec3 ray) {
  float key = max(dot(normal, uKeyLight), 0.0);
  float sky = 0.5 + 0.5 * normal.z;
  float shine = pow(max(dot(normal, normalize(uKeyLight - ray)), 0.0), 40.0);
  float facing = 1.0 + dot(normal, ray);
  vec3 albedo = own * own;  // about from sRGB to light
  vec3 light = albedo * (0.75 * key + mix(vec3(0.26, 0.24, 0.23), vec3(0.46, 0.49, 0.54), sky));
  light += vec3(0.10 * shine) + vec3(0.05, 0.055, 0.06) * facing * facing * facing;
  return sqrt(clamp(light, 0.0, 1.0));
}
