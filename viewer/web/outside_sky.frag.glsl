in vec3 vSky;
out vec4 colour;
void main() { colour = vec4(vSky, 1.0); }
