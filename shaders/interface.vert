#version 330 core
layout(location = 0) in vec2 position;   // pixels from the upper left corner
layout(location = 1) in vec2 texture_position;
layout(location = 2) in vec4 color;
uniform vec4 display;                    // left, top, width, height
out vec2 uv;
out vec4 tint;

void main() {
    uv = texture_position;
    tint = color;
    vec2 unit = (position - display.xy) / display.zw;
    gl_Position = vec4(2.0 * unit.x - 1.0, 1.0 - 2.0 * unit.y, 0.0, 1.0);
}
