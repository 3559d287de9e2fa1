// What surrounds the cells: the sphere at infinity of the ball, or the plane at infinity below the
// upper half-space with a grid.
uniform int uModel;  // 0 upper half-space, 1 ball
uniform vec3 uHigh, uLow, uInk;  // background above and below, colour of lines
uniform int uFront;  // 1: the near side of the glass ball, blended over the cells
out vec4 colour;

float gridLine(float x, float footprint) {
  float away = abs(x - round(x));
  return 1.0 - smoothstep(0.5 * footprint, 1.5 * footprint + 1e-4, away);
}

/// The rim of the glass ball seen along a ray: 0 in the middle and outside.
float glass(vec3 ray) {
  float b = dot(uEye, ray), c = dot(uEye, uEye) - 1.0;
  float discriminant = b * b - c;
  if (discriminant <= 0.0) return 0.0;
  float facing = sqrt(discriminant);  // the cosine at which the ray meets the unit sphere
  float soft = smoothstep(0.0, 3.0 * sqrt(uPixel), facing);
  return soft * pow(1.0 - min(facing, 1.0), 4.0);
}

void main() {
  vec3 ray = rayThroughPixel(gl_FragCoord.xy);
  gl_FragDepth = uFront == 1 ? 0.0 : 1.0;
  if (uOutput == kIdentities) {
    if (uFront == 1) discard;
    colour = vec4(0.0, 0.0, 0.0, 1.0);
    return;
  }
  if (uFront == 1) {
    colour = vec4(uInk, uModel == 1 ? 0.22 * glass(ray) : 0.0);
    return;
  }
  float height = gl_FragCoord.y / uSize.y;
  vec3 back = mix(uLow, uHigh, smoothstep(0.0, 1.0, height));
  if (uModel == 1) {
    back = mix(back, uInk, 0.30 * glass(ray));
  } else if (ray.z < -1e-4) {
    float s = -uEye.z / ray.z;
    vec2 p = (uEye + s * ray).xy;
    float away = length(p);
    float footprint = s * uPixel * 4.0 / max(-ray.z, 0.15);
    float line = max(gridLine(p.x * 4.0, footprint), gridLine(p.y * 4.0, footprint));
    float circle = 1.0 - smoothstep(0.0, footprint * 0.4, abs(away - 1.0));
    float fade = exp(-0.35 * away * away);
    back = mix(back, uInk, fade * max(0.16 * line, 0.35 * circle));
    back *= 1.0 - 0.16 * exp(-3.0 * max(away - 0.9, 0.0)) * fade;  // a soft shadow
    gl_FragDepth = depthOf(s);
  }
  colour = finite(toDisplay(back));
}
