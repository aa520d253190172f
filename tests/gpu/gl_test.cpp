#include <array>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "support/contains.hpp"
#include "window/context.hpp"

using namespace sunder;
using namespace sunder::core;
using namespace sunder::gl;
using namespace sunder::window;

namespace {

/// What `call` throws as an E; empty when it does not.
template <class E, class Call>
std::string thrown(Call call) {
    try {
        call();
    } catch (const E& error) {
        return error.what();
    }
    return {};
}

/// Draws need a complete framebuffer, even when they draw nothing.
struct Target {
    Texture colour = makeTexture2D(1, 1, GL_RGBA8, "test target");
    Framebuffer framebuffer = makeFramebuffer();
    Target() {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour.id(), 0);
        REQUIRE(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    }
};

ProgramDescription tinyProgram(std::string vertex, std::string included = "") {
    ProgramDescription description{.vertex = "tiny.vert"};
    description.source = [=](std::string_view name) -> std::optional<std::string> {
        if (name == "tiny.vert") return vertex;
        if (name == "included.glsl") return included;
        return std::nullopt;
    };
    return description;
}

}  // namespace

TEST_CASE("A context without a window can be had, again and again") {
    for (int i = 0; i < 3; ++i) {
        const auto context = createHeadlessContext();
        const DeviceInfo& info = context->info();
        CHECK_FALSE(info.renderer.empty());
        CHECK_FALSE(info.device.empty());
        CHECK(info.maxTextureSize >= 16384);
        CHECK(info.maxTextureBufferSize >= 65536);
        CHECK(info.maxUniformBlockSize >= 16384);
        CHECK(info.maxTransformFeedbackComponents >= 64);
        CHECK(info.maxGeometryOutputComponents >= 1024);
        CHECK(info.maxSamples >= 4);
        CHECK(context->takeErrors().empty());
    }
}

TEST_CASE("Every device is listed, and the one in use is among them") {
    const std::string device = createHeadlessContext()->info().device;
    bool found = false;
    for (const DeviceListEntry& entry : listDevices()) {
        CHECK(entry.usable != entry.info.renderer.empty());
        CHECK(entry.usable == entry.problem.empty());
        found |= entry.usable && entry.description == device;
    }
    CHECK(found);
}

TEST_CASE("Transform feedback writes what the shader computed") {
    const auto context = createHeadlessContext();
    const Target target;
    constexpr int kCount = 1234;
    std::vector<float> input(kCount);
    std::iota(input.begin(), input.end(), -600.5f);

    ProgramDescription description = tinyProgram(
        "#include \"included.glsl\"\n"
        "uniform samplerBuffer offsets;\n"
        "in float value;\n"
        "out float result;\n"
        "void main() { result = twice(value) + texelFetch(offsets, gl_VertexID).x * SCALE; }\n",
        "float twice(float x) { return 2.0 * x; }\n");
    description.defines = {{"SCALE", "4.0"}};
    description.feedback = {"result"};
    description.attributes = {{"value", 5}};
    const Program program(description);

    const Buffer values = makeBuffer<float>(input, GL_STATIC_DRAW, "values");
    const Texture offsets = makeBufferTexture(values, GL_R32F, "offsets");
    const Buffer results(kCount * sizeof(float), nullptr, GL_DYNAMIC_COPY, "results");
    const VertexArray vertices = makeVertexArray();
    glBindVertexArray(vertices.id());
    glBindBuffer(GL_ARRAY_BUFFER, values.id());
    glVertexAttribPointer(5, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(5);
    bindTexture(3, GL_TEXTURE_BUFFER, offsets);
    program.bindSampler("offsets", 3);

    glEnable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, results.id());
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, kCount);
    glEndTransformFeedback();

    std::vector<float> output(kCount);
    results.read(0, results.size(), output.data());
    context->check();
    for (std::size_t i = 0; i < output.size(); ++i) REQUIRE(output[i] == 6.0f * input[i]);
}

TEST_CASE("A buffer takes and gives back parts of itself") {
    const auto context = createHeadlessContext();
    const std::array<std::uint32_t, 5> data{10, 11, 12, 13, 14};
    Buffer buffer = makeBuffer<std::uint32_t>(data, GL_STATIC_DRAW, "numbers");
    CHECK(buffer.size() == 20);
    const std::array<std::uint32_t, 2> patch{98, 99};
    buffer.write(4, 8, patch.data());
    std::array<std::uint32_t, 3> tail{};
    buffer.read(8, 12, tail.data());
    CHECK(tail == std::array<std::uint32_t, 3>{99, 13, 14});
    const Buffer empty(0, nullptr, GL_STATIC_DRAW, "nothing");
    CHECK(empty.size() == 0);
    context->check();
}

TEST_CASE("A handle moves: the source is empty, the old object is deleted") {
    const auto context = createHeadlessContext();
    VertexArray first = makeVertexArray();
    VertexArray second = makeVertexArray();
    glBindVertexArray(first.id());
    glBindVertexArray(second.id());
    const GLuint firstId = first.id(), secondId = second.id();

    VertexArray moved(std::move(first));
    CHECK(moved.id() == firstId);
    CHECK(first.id() == 0);  // NOLINT(bugprone-use-after-move): the documented state
    CHECK_FALSE(first);

    moved = std::move(second);
    CHECK(moved.id() == secondId);
    CHECK(glIsVertexArray(firstId) == GL_FALSE);
    CHECK(glIsVertexArray(secondId) == GL_TRUE);

    VertexArray& itself = moved;
    moved = std::move(itself);
    CHECK(moved.id() == secondId);

    moved = VertexArray();
    CHECK(glIsVertexArray(secondId) == GL_FALSE);
    context->check();
}

TEST_CASE("A shader error names the file and line it stands in") {
    const auto context = createHeadlessContext();
    // Mesa: included.glsl:3(…); NVIDIA: included.glsl(3); Apple: included.glsl:3:
    const auto names = [](const std::string& message, const std::string& file,
                          const std::string& line) {
        return contains(message, file + ":" + line + "(") ||
               contains(message, file + ":" + line + ":") ||
               contains(message, file + "(" + line + ")");
    };
    SECTION("in an included file") {
        const std::string message = thrown<std::runtime_error>([] {
            Program(tinyProgram("#include \"included.glsl\"\nvoid main() {}\n",
                                "\n// three\nfloat f() { return undeclared; }\n"));
        });
        INFO(message);
        CHECK(contains(message, "tiny.vert does not compile"));
        CHECK(names(message, "included.glsl", "3"));
    }
    SECTION("after an included file") {
        const std::string message = thrown<std::runtime_error>([] {
            Program(tinyProgram("#include \"included.glsl\"\n\n\nvoid main() { undeclared = 1; }\n",
                                "float one() { return 1.0; }\n"));
        });
        INFO(message);
        CHECK(names(message, "tiny.vert", "4"));
    }
    SECTION("at the link") {
        ProgramDescription description = tinyProgram("void main() { gl_Position = vec4(0.0); }\n");
        description.feedback = {"nowhere"};
        const std::string message =
            thrown<std::runtime_error>([&] { Program program(description); });
        INFO(message);
        CHECK(contains(message, "tiny.vert does not link"));
        CHECK(contains(message, "nowhere"));
    }
    // The exception told it; it is not told twice.
    CHECK(context->takeErrors().empty());
}

TEST_CASE("A GL error is collected once, and check() throws it") {
    const auto context = createHeadlessContext();
    glEnable(GL_TEXTURE_2D + 0x7000);
    const std::vector<std::string> errors = context->takeErrors();
    REQUIRE(errors.size() == 1);
    CHECK(contains(errors.front(), "INVALID_ENUM"));
    CHECK(context->takeErrors().empty());
    CHECK_NOTHROW(context->check());

    glEnable(GL_TEXTURE_2D + 0x7000);
    CHECK_THROWS_AS(context->check(), std::runtime_error);
    CHECK_NOTHROW(context->check());
}

TEST_CASE("What the device cannot hold is refused by name") {
    const auto context = createHeadlessContext();
    const DeviceInfo& info = context->info();
    SECTION("a buffer") {
        const auto most = static_cast<std::size_t>(PTRDIFF_MAX);
        const auto make = [](std::size_t bytes) {
            return thrown<InputError>(
                [&] { Buffer(bytes, nullptr, GL_STATIC_DRAW, "node state"); });
        };
        CHECK(contains(make(most / 2), "no memory for the node state (4611686018427 MB)"));
        CHECK(contains(make(most + 1), "no memory for the node state"));
    }
    SECTION("a buffer texture") {
        const auto texels = static_cast<std::size_t>(info.maxTextureBufferSize) + 1;
        const Buffer buffer(texels, nullptr, GL_STATIC_DRAW, "texels");
        const std::string message =
            thrown<InputError>([&] { makeBufferTexture(buffer, GL_R8, "rest state"); });
        CHECK(message == "the world is too large for this device: rest state needs " +
                             std::to_string(texels) + " texels, " + info.renderer + " takes " +
                             std::to_string(info.maxTextureBufferSize));
    }
    SECTION("a texture") {
        const int width = info.maxTextureSize + 1;
        const std::string message =
            thrown<InputError>([&] { makeTexture2D(width, 1, GL_R8, "shadow map"); });
        CHECK(contains(message, "shadow map"));
        CHECK(contains(message, std::to_string(info.maxTextureSize)));
    }
    // Each was handled where it happened.
    CHECK(context->takeErrors().empty());
}
