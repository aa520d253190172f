// A rectangle of texels per instance, two triangles each: a fragment for every texel that is to be filled.
uniform isamplerBuffer rectangles;  // first column, first row, end column, end row
uniform ivec2 targetSize;           // columns, rows

void main() {
    ivec4 rectangle = texelFetch(rectangles, gl_InstanceID);
    int corner = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID;  // 0 1 2, 3 2 1
    ivec2 texel = ivec2((corner & 1) == 0 ? rectangle.x : rectangle.z, (corner & 2) == 0 ? rectangle.y : rectangle.w);
    gl_Position = vec4(2.0 * vec2(texel) / vec2(targetSize) - 1.0, 0.0, 1.0);
}
