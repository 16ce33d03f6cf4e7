#version 330 core
in vec4 tint;
in float depth_span;
uniform float opacity;
uniform int ring;                        // 1: a ring with a clear middle, so that what it surrounds stays visible
out vec4 color;

void main() {
    vec2 p = 2.0 * gl_PointCoord - 1.0;
    float r = length(p);
    float pixel = fwidth(p.x);
    float rim = 1.0 - pixel;
    float cover = 1.0 - smoothstep(rim - pixel, rim, r);
    if (ring == 1) cover *= smoothstep(0.58 - pixel, 0.58 + pixel, r);
    if (cover <= 0.01) discard;
    float height = sqrt(max(1.0 - r * r, 0.0));
    vec3 normal = vec3(p.x, -p.y, height);
    float diffuse = max(dot(normal, normalize(vec3(-0.35, 0.65, 0.7))), 0.0);
    vec3 lit = ring == 1 ? tint.rgb : tint.rgb * (0.55 + 0.5 * diffuse);
    // A dark rim separates the marker from a body of similar brightness.
    if (ring == 0) lit *= 1.0 - 0.55 * smoothstep(0.72, 0.95, r);
    color = vec4(lit, tint.a * opacity * cover);
    gl_FragDepth = gl_FragCoord.z - depth_span * height;
}
