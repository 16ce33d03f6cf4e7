#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in float value;     // scalar field, 0 to 1 on the colour map
layout(location = 2) in vec4 tint;       // of the face: colour and its share
uniform mat4 view;
uniform mat4 projection;
uniform int face_nodes;                  // 3, 4 or 6: which sides of a triangle are sides of an element
out vec3 corner;                         // barycentric; a component stays 1 where the opposite side is not drawn
out vec3 seen;                           // position in view space
out float level;
flat out vec4 face_tint;

void main() {
    int c = gl_VertexID % 3;
    corner = vec3(c == 0, c == 1, c == 2);
    // Triangles are ordered so that the side inside a quadrilateral or quadratic face lies opposite corner 1; of the four
    // triangles of a quadratic face the last is all inside.
    if (face_nodes != 3) corner.y = 1.0;
    if (face_nodes == 6 && (gl_VertexID / 3) % 4 == 3) corner = vec3(1.0);
    level = value;
    face_tint = tint;
    vec4 p = view * vec4(position, 1.0);
    seen = p.xyz;
    gl_Position = projection * p;
}
