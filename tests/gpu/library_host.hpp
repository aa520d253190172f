#pragma once
// A host of the library's part on the GPU, for its tests.
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "gl/functions.hpp"
#include "gpu/hostile_host.hpp"
#include "gpu/state_dump.hpp"
#include "sunder/gl_device.hpp"
#include "window/context.hpp"

namespace library_host {

using namespace sunder;

inline constexpr double kFrame = 1.0 / 60;

/// A host: a context of its own, in which every call must leave everything as it was.
struct Host {
    Host() : context(window::createHeadlessContext()) {}
    gl::DeviceOptions options() {
        return {
            .getProcAddress = [this](const char* name) { return context->loadFunction()(name); }};
    }
    /// Whether a call leaves the context as it is.
    template <class Call>
    void unnoticed(const char* what, Call call) {
        INFO(what);
        const StateDump before = dumpState();
        context->takeErrors();
        call();
        CHECK(context->takeErrors() == std::vector<std::string>{});
        CHECK(differences(before, dumpState()) == std::vector<std::string>{});
        context->takeErrors();
    }
    std::unique_ptr<window::Context> context;
    HostileHost hostile;
};

inline WorldDesc wallAndBall() {
    WorldDesc desc;
    const int brick = desc.addMaterial(Material::preset("brick"));
    const int glass = desc.addMaterial(Material::preset("glass"));
    desc.addBody(
        {.material = brick, .size = {0.9, 0.6, 0.2}, .cells = {6, 4, 2}, .anchors = Side::Bottom});
    desc.addBody({.material = glass,
                  .size = {0.3, 0.3, 0.05},
                  .cells = {3, 3, 1},
                  .position = {1.2, 0, 0},
                  .orientation = {0.8, 0, 0.6, 0},
                  .anchors = Side::Bottom});
    Object ball = Object::sphere(0.15).at({0, 0.35, 0.35});
    ball.mass = 40;
    ball.velocity = {0, 0, -20};
    desc.addObject(ball);
    return desc;
}

inline World made(const WorldDesc& desc, const WorldOptions& options) {
    Result<World> world = World::create(desc, options);
    INFO((world ? std::string() : world.error().message));
    REQUIRE(world);
    return std::move(*world);
}

/// All that a buffer of the host's context holds.
template <class T>
std::vector<T> contentOf(GLuint buffer) {
    GLint bytes = 0;
    glBindBuffer(GL_COPY_READ_BUFFER, buffer);
    glGetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &bytes);
    std::vector<T> content(static_cast<std::size_t>(bytes) / sizeof(T));
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, bytes, content.data());
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    return content;
}

inline std::vector<gl::Vertex> verticesOf(const gl::Surface& surface) {
    std::vector<gl::Vertex> vertices = contentOf<gl::Vertex>(surface.vertexBuffer());
    REQUIRE(vertices.size() == static_cast<std::size_t>(surface.vertices()));
    return vertices;
}

inline bool same(const std::vector<gl::Vertex>& a, const std::vector<gl::Vertex>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

/// Counts the calls with which a program waits for a GPU or reads from it.
class ReadCounter {
  public:
    explicit ReadCounter(gl::Functions& functions) : functions_(functions), before_(functions) {
        count_ = waits_ = 0;
        original_ = &before_;
        functions.GetBufferSubData = [](GLenum a, GLintptr b, GLsizeiptr c, void* d) {
            ++count_;
            original_->GetBufferSubData(a, b, c, d);
        };
        functions.ReadPixels = [](GLint a, GLint b, GLsizei c, GLsizei d, GLenum e, GLenum f,
                                  void* g) {
            // Into a buffer, nobody waits for it.
            wait(gl::boundName(GL_PIXEL_PACK_BUFFER_BINDING) == 0);
            original_->ReadPixels(a, b, c, d, e, f, g);
        };
        functions.Finish = [] {
            wait(true);
            original_->Finish();
        };
    }
    ~ReadCounter() { functions_ = before_; }
    ReadCounter(const ReadCounter&) = delete;
    ReadCounter& operator=(const ReadCounter&) = delete;
    static int take() { return std::exchange(count_, 0); }
    /// Those among them that wait for all that was asked of the GPU. What was copied into a buffer
    /// a while ago is there.
    static int takeWaits() { return std::exchange(waits_, 0); }

  private:
    static void wait(bool does) {
        count_ += does;
        waits_ += does;
    }
    gl::Functions& functions_;
    gl::Functions before_;
    static inline int count_ = 0, waits_ = 0;
    static inline gl::Functions* original_ = nullptr;
};

}  // namespace library_host
