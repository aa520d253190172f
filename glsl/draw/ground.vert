// A square of ground at y = 0 around the point below the camera.
uniform mat4 viewProjection;
uniform vec3 eye;
uniform float extent;  // m, half a side

out vec3 position;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    position = vec3(eye.x + extent * corner.x, 0.0, eye.z - extent * corner.y);
    gl_Position = viewProjection * vec4(position, 1.0);
}
