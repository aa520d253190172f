#include "gl/vertex_array.hpp"

namespace sunder::gl {

VertexArray makeVertexArray(const std::vector<VertexInput>& inputs, const Buffer* indices) {
    VertexArray array = makeVertexArray();
    glBindVertexArray(array.id());
    for (const VertexInput& input : inputs) {
        glBindBuffer(GL_ARRAY_BUFFER, input.buffer.id());
        const auto stride = static_cast<GLsizei>(input.stride);
        for (const Attribute& attribute : input.attributes) {
            const auto* const offset = reinterpret_cast<const void*>(attribute.offset);
            glEnableVertexAttribArray(attribute.location);
            if (attribute.type == GL_FLOAT)
                glVertexAttribPointer(attribute.location, attribute.components, GL_FLOAT, GL_FALSE,
                                      stride, offset);
            else
                glVertexAttribIPointer(attribute.location, attribute.components, attribute.type,
                                       stride, offset);
        }
    }
    if (indices) glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices->id());
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    return array;
}

}  // namespace sunder::gl
