#include "gl/functions.hpp"

#include <cstddef>
#include <string>

#include "catch.hpp"
#include "gl/objects.hpp"
#include "gpu/test_context.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// Leaves GL_OUT_OF_MEMORY behind, as a driver does that misses memory only in the midst of work.
class Exhausted {
  public:
    Exhausted() {
        glGenBuffers(1, &buffer_);
        glBindBuffer(GL_COPY_WRITE_BUFFER, buffer_);
        // 2^50 bytes: more than any device has.
        glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr{1} << 50, nullptr, GL_STATIC_DRAW);
    }
    ~Exhausted() { glDeleteBuffers(1, &buffer_); }
    Exhausted(const Exhausted&) = delete;
    Exhausted& operator=(const Exhausted&) = delete;

  private:
    GLuint buffer_ = 0;
};

}  // namespace

TEST_CASE("memory missing is bad input, whether at an allocation, before it or in between") {
    window::Context& context = testContext();
    const std::string advice = "; use fewer cells, smaller pictures or the solver cpu";
    SECTION("while it works") {
        const Exhausted exhausted;
        CHECK_THROWS_AS(context.check(), InputError);
        // Said once; what works afterwards is not refused.
        CHECK_NOTHROW(context.check());
        const Exhausted again;
        CHECK_THROWS_WITH(context.check(), "the device has no memory left" + advice);
    }
    SECTION("before an allocation that would have found room") {
        const Exhausted exhausted;
        CHECK_THROWS_AS(gl::Buffer(4, nullptr, GL_STATIC_DRAW, "numbers"), InputError);
        const Exhausted again;
        CHECK_THROWS_WITH(gl::Buffer(4, nullptr, GL_STATIC_DRAW, "numbers"),
                          "the device has no memory left" + advice);
    }
    SECTION("at it") {
        const std::size_t bytes = std::size_t{1} << 50;
        CHECK_THROWS_AS(gl::Buffer(bytes, nullptr, GL_STATIC_DRAW, "numbers"), InputError);
        CHECK_THROWS_WITH(gl::Buffer(bytes, nullptr, GL_STATIC_DRAW, "numbers"),
                          "the device has no memory for the numbers (1125899907 MB)" + advice);
    }
}
