// What surrounds the cells, drawn after them where they left the picture free: the sphere at infinity
// of the ball, or the plane at infinity below the upper half-space with a grid. kUpper, whether it is
// the latter, is defined in front of it.
uniform vec3 uHigh, uLow;  // background above and below
out vec4 colour;

float gridLine(float x, float footprint) {
  float away = abs(x - round(x));
  return 1.0 - smoothstep(0.5 * footprint, 1.5 * footprint + 1e-4, away);
}

void main() {
  vec3 ray = rayThroughPixel(gl_FragCoord.xy);
  float height = heightOnPicture(gl_FragCoord.y);
  vec3 back = mix(uLow, uHigh, smoothstep(0.0, 1.0, height));
#if kUpper
  if (ray.z < -1e-4) {
    float s = -uEye.z / ray.z;
    vec2 p = (uEye + s * ray).xy;
    float away = length(p);
    float footprint = s * uPixel * 4.0 / max(-ray.z, 0.15);
    float line = max(gridLine(p.x * 4.0, footprint), gridLine(p.y * 4.0, footprint));
    float circle = 1.0 - smoothstep(0.0, footprint * 0.4, abs(away - 1.0));
    float fade = exp(-0.35 * away * away);
    back = mix(back, uInk, fade * max(0.16 * line, 0.35 * circle));
    back *= 1.0 - 0.16 * exp(-3.0 * max(away - 0.9, 0.0)) * fade;  // a soft shadow
  }
#else
  back = mix(back, uInk, 0.30 * glass(ray));
#endif
  colour = uOutput == kIdentities ? vec4(0.0, 0.0, 0.0, 1.0)
                                  : finite(throughGlass(toDisplay(back), ray));
}
