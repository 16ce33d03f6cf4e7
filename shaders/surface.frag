#version 330 core
in vec3 corner;
in vec3 seen;
in float level;
flat in vec4 face_tint;
uniform vec3 base_color;
uniform vec4 edge_color;
uniform float edge_width;                // pixels at a scale of 1; 0 = none
uniform float scale;                     // pixels of the picture in one of those
uniform float opacity;
uniform int use_field;
uniform sampler2D color_map;             // one map in each row
uniform float color_row;
out vec4 color;

void main() {
    // Flat shading from screen derivatives: right for any deformation without normals to update.
    vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
    vec3 to_eye = normalize(-seen);
    vec3 key = normalize(vec3(-0.35, 0.65, 0.7));
    float diffuse = max(dot(normal, key), 0.0);
    float fill = 0.5 + 0.5 * normal.y;
    float facing = max(dot(normal, to_eye), 0.0);
    vec3 base = use_field == 1 ? texture(color_map, vec2(clamp(level, 0.0, 1.0), color_row)).rgb : base_color;
    base = mix(base, face_tint.rgb, face_tint.a);
    vec3 lit = base * (0.30 + 0.48 * diffuse + 0.16 * fill + 0.12 * facing);

    if (edge_width > 0.0) {
        vec3 step_size = fwidth(corner) * scale;
        vec3 distance_px = corner / max(step_size, vec3(1e-6));
        float nearest = min(distance_px.x, min(distance_px.y, distance_px.z));
        float line = 1.0 - smoothstep(edge_width - 0.5 / scale, edge_width + 0.5 / scale, nearest);
        // Elements of few pixels would turn into a dark blot: their edges fade.
        float crowding = max(step_size.x, max(step_size.y, step_size.z));
        line *= 1.0 - smoothstep(0.12, 0.45, crowding);
        lit = mix(lit, edge_color.rgb, line * edge_color.a);
    }
    color = vec4(lit, opacity);
}
