#version 330 core
// One instance per segment: two triangles around it, as wide as asked for on the screen.
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 color;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 size;                       // of the view [pixels]
uniform float width;                     // [pixels]
out vec4 tint;

void main() {
    int corner = gl_VertexID % 6;
    float along = (corner == 1 || corner == 2 || corner == 4) ? 1.0 : 0.0;
    float side = (corner == 2 || corner == 4 || corner == 5) ? 1.0 : -1.0;
    vec4 a = view * vec4(from, 1.0);
    vec4 b = view * vec4(to, 1.0);
    // An end behind the eye is pulled in front of it, else its projection is mirrored.
    float front = -1e-4;
    if (a.z > front && b.z < front) a = mix(a, b, (front - a.z) / (b.z - a.z));
    if (b.z > front && a.z < front) b = mix(b, a, (front - b.z) / (a.z - b.z));
    vec4 pa = projection * a;
    vec4 pb = projection * b;
    vec2 direction = (pb.xy / pb.w - pa.xy / pa.w) * size;
    float extent = length(direction);
    direction = extent > 1e-6 ? direction / extent : vec2(1.0, 0.0);
    vec2 normal = vec2(-direction.y, direction.x);
    vec4 p = along > 0.5 ? pb : pa;
    p.xy += normal * side * width / size * p.w;
    tint = color;
    gl_Position = p;
}
