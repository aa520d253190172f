#include <glad/gl.h>

#include <cstdint>

#include "catch.hpp"
#include "gpu/test_context.hpp"

using namespace sunder;

TEST_CASE("a device that runs out of memory while it works is no usable context") {
    gl::Context& context = testContext();
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
    // 2^50 bytes: more than any device has.
    glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr{1} << 50, nullptr, GL_STATIC_DRAW);
    CHECK_THROWS_AS(context.check(), ContextError);
    glDeleteBuffers(1, &buffer);
    // Said once; what works afterwards is not refused.
    CHECK_NOTHROW(context.check());
}
