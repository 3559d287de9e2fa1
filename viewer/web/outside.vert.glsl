// One square for each cell, which covers its bounding sphere as the camera sees it.
uniform sampler2D uCells;
uniform int uCellsPerRow;
uniform float uExplode;
uniform mat4 uProjection;  // from the space of the model to the picture

flat out ivec2 vFirst;  // texel where the cell's numbers begin
flat out int vCell;
flat out vec3 vCentre;
flat out float vRadius;

void main() {
  vCell = gl_InstanceID;
  vFirst = ivec2((gl_InstanceID % uCellsPerRow) * 19, gl_InstanceID / uCellsPerRow);
  vec4 sphere = texelFetch(uCells, vFirst + ivec2(10, 0), 0);
  vCentre = sphere.xyz;
  // Moving the cells apart and stepping back looks the same as shrinking them where they are.
  vRadius = sphere.w / (1.0 + uExplode);

  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec3 view = vCentre - uEye;
  float distance = length(view);
  if (distance <= vRadius * 1.01) {  // the camera is inside the sphere
    gl_Position = vec4(corner, 0.0, 1.0);
    return;
  }
  vec3 forward = view / distance;
  vec3 side = normalize(cross(forward, abs(forward.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0)));
  vec3 up = cross(side, forward);
  // The tangent cone meets the plane through the centre in a larger circle than the sphere's own.
  float reach = vRadius * distance / sqrt(distance * distance - vRadius * vRadius);
  vec4 position = uProjection * vec4(vCentre + reach * (corner.x * side + corner.y * up), 1.0);
  gl_Position = vec4(position.xy, 0.0, position.w);  // the fragments compute their own depth
}
