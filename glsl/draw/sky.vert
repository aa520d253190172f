// One triangle that covers the screen, as far away as depth goes. Directions are differences of far and near points, so no camera
// position is needed.
uniform mat4 inverseViewProjection;

out vec3 direction;

void main() {
    vec2 p = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    vec4 near = inverseViewProjection * vec4(p, -1.0, 1.0);
    vec4 far = inverseViewProjection * vec4(p, 1.0, 1.0);
    direction = far.xyz / far.w - near.xyz / near.w;
    gl_Position = vec4(p, 1.0, 1.0);
}
