#version 330 core
in vec4 tint;
uniform float opacity;
out vec4 color;

void main() { color = vec4(tint.rgb, tint.a * opacity); }
