#version 330 core
// A sphere is one point that the fragment shader rounds.
layout(location = 0) in vec3 center;
layout(location = 1) in vec4 color;
uniform mat4 view;
uniform mat4 projection;
uniform float radius;                    // [m]
uniform vec2 pixel_limits;               // smallest and largest radius [pixels]
uniform float view_height;               // [pixels]
out vec4 tint;
out float depth_span;                    // depth of the centre minus depth of the nearest point

void main() {
    vec4 p = view * vec4(center, 1.0);
    gl_Position = projection * p;
    float pixels_per_metre = 0.5 * view_height * projection[1][1] / gl_Position.w;
    float pixels = clamp(radius * pixels_per_metre, pixel_limits.x, pixel_limits.y);
    gl_PointSize = 2.0 * pixels + 2.0;
    vec4 nearest = projection * (p + vec4(0.0, 0.0, pixels / pixels_per_metre, 0.0));
    depth_span = 0.5 * (gl_Position.z / gl_Position.w - nearest.z / nearest.w);
    tint = color;
}
