// An octagon around the unit ball as the eye, which is outside, sees it, behind everything. After a
// camera that hands its numbers on.
void main() {
  handOn();
  float away = length(uEye);
  vec3 towards = uEye / away;
  vec3 side = normalize(cross(towards, abs(towards.z) < 0.8 ? vec3(0, 0, 1) : vec3(1, 0, 0)));
  // Around the circle where rays touch the ball; a little wider, as 1 / cos 22.5 degrees is 1.0824.
  float angle = float(gl_VertexID) * 0.78539816, reach = 1.1 * sqrt(1.0 - 1.0 / (away * away));
  vec3 corner = towards / away + reach * (cos(angle) * side + sin(angle) * cross(towards, side));
  vec3 seen = (corner - uEye) * uAxes;
  gl_Position = vec4(seen.xy / uTangent, seen.z, seen.z);
}
