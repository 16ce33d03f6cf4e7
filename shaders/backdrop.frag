#version 330 core
in float up;
uniform vec3 top;
uniform vec3 bottom;
out vec4 color;

void main() { color = vec4(mix(bottom, top, up), 1.0); }
