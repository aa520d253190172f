// For a host's own vertex shader, after draw/display.vert with HOST_VERTEX and SURFACE, whose names by then begin with sunder_
// (src/sim_gl/host_vertex.cpp; sunder/gl.hpp, Surface::vertexShader()).
struct SunderVertex {
    vec3 position;  // m, world
    vec3 normal;    // of length 1, outwards
    vec4 tangent;   // of length 1, the way in which texCoord.x grows; w: sign of the bitangent, cross(normal, tangent)
    vec3 place;     // m, in the body's own axes from its lowest corner, at rest
    vec2 texCoord;  // m, across the face at rest
    int body;
    int cell;
    bool inside;    // what a break bares
};

// Corners of a face that nothing can see have one position, and no place.
SunderVertex sunderVertex() {
    sunder_displayedVertex();
    int axis = int(sunder_owner.y >> uint(SUNDER_DISPLAY_FACE_BIT + 1) & 3u);
    vec2 across = vec2(axis == 0 ? sunder_place.z : sunder_place.x, axis == 1 ? sunder_place.z : sunder_place.y);
    return SunderVertex(sunder_position, sunder_normal, sunder_tangent, sunder_place, across,
                        int(texelFetch(sunder_cells, int(sunder_owner.x)).g), int(sunder_owner.x),
                        (sunder_owner.y & SUNDER_DISPLAY_FACE_INNER) != 0u);
}
