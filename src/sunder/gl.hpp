/// Sunder on the GPU, as a guest in a program's own OpenGL context (4.1 core or newer, or a
/// compatibility context of that version). Needs no header of OpenGL and no library of it: every
/// function comes from the host's own loader.
#pragma once
#include <sunder/export.h>
#include <sunder/sunder.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace sunder::gl {

/// What becomes of the host's GL state in a call.
enum class State {
    /// All of it is afterwards as it was before; that costs microseconds a call.
    Restored,
    /// Nothing is put back, for hosts that set all state before they draw. Sunder sets what it
    /// depends on and leaves framebuffers, a vertex array, a program, buffers and textures of its
    /// own bound, on any active unit, with any viewport; all but dithering and multisampling is
    /// disabled. No transform feedback may be active.
    Dirty,
};

/// Finds a GL function by its name: glfwGetProcAddress, eglGetProcAddress, SDL_GL_GetProcAddress,
/// or anything that can be called with a `const char*` and returns a pointer.
class GetProcAddress {
  public:
    /// None: a Device made with it says so.
    GetProcAddress() = default;
    /// From a function or an object that can be called.
    template <class F,
              class = std::enable_if_t<std::is_pointer_v<std::invoke_result_t<F&, const char*>>>>
    GetProcAddress(F find)
        : find_([find](const char* name) mutable {
              return reinterpret_cast<Function>(find(name));
          }) {}
    /// Any function; its type is not its own.
    using Function = void (*)();
    /// The function of this name; null: there is none.
    Function operator()(const char* name) const { return find_ ? find_(name) : nullptr; }
    /// Whether there is something to ask.
    explicit operator bool() const { return static_cast<bool>(find_); }

  private:
    std::function<Function(const char*)> find_{};
};

/// How a Device uses a context.
struct DeviceOptions {
    GetProcAddress getProcAddress{};  ///< Where GL's functions come from.
    State state = State::Restored;    ///< What becomes of the host's state.
    /// Is told what goes wrong in the driver without a call failing. Called within calls.
    std::function<void(std::string_view message)> log{};
    /// Whether glGetError is asked in every call. Then memory that is missing is noticed wherever
    /// it is missing, but what the host had pending is lost to it (and told to `log`).
    bool askErrors = false;
};

/// A context of the host's that worlds may be simulated in. The context must be current on the
/// calling thread whenever this, a world made with it or a Surface is used or destroyed; Sunder
/// never makes it current. Several devices may be used in turn. What a host cannot have Sunder put
/// back: it must not call within a query that counts samples, primitives or transform feedback,
/// within conditional rendering, or between glBegin and glEnd.
class SUNDER_API Device : public sunder::Device {
  public:
    /// Adopts the context that is current. Where that fails, ok() is false, and World::create() and
    /// Surface fail with error().
    explicit Device(DeviceOptions options);
    ~Device() override;                         ///< The host's context stays as it is.
    Device(const Device&) = delete;             ///< There is one for a context.
    Device& operator=(const Device&) = delete;  ///< There is one for a context.

    /// Whether it can be used.
    bool ok() const;
    /// Why it cannot be used.
    const Error& error() const;
    /// What the driver calls the GPU, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
    std::string_view renderer() const;
    /// Bytes of buffers and textures that Sunder holds there.
    std::size_t memory() const;
    /// To be called where the host has destroyed the context: what was in it is gone, and whatever
    /// is destroyed from now on only lets go of it. Everything else fails.
    void contextGone();

    /// For Sunder's own parts.
    struct Impl;
    /// For Sunder's own parts.
    Impl& impl() const { return *impl_; }

  private:
    Result<sim::Backend*> backend() override;
    std::unique_ptr<Impl> impl_;
};

/// A vertex of a Surface that changes with every update: 40 bytes, as they lie in vertexBuffer().
struct Vertex {
    float position[3];  ///< m, world. Location 0.
    float normal[3];    ///< Of length 1, outwards. Location 1.
    /// Of length 1, the way in which the first texture coordinate grows; the fourth number is the
    /// sign of the bitangent, cross(normal, tangent). Location 2.
    float tangent[4];
};

/// A vertex of a Surface that stays the same: 40 bytes, as they lie in restBuffer().
struct RestVertex {
    float place[3];     ///< m, in the body's own axes from its lowest corner, at rest. Location 3.
    float texCoord[2];  ///< m, across the face at rest: one unit is a metre. Location 4.
    std::int32_t material;  ///< Index, of WorldDesc::materials. Location 5, an integer.
    std::int32_t body;      ///< Index, of WorldDesc::bodies. Location 6, an integer.
    std::int32_t cell;      ///< World-wide index of its cell. Location 7, an integer.
    std::int32_t inside;    ///< 1 on what a break bares, 0 on the outside. Location 8, an integer.
    std::int32_t reserved;  ///< 0.
};

/// Triangles of one material.
struct Range {
    int material = 0;          ///< Index, of WorldDesc::materials.
    bool inside = false;       ///< What a break bares; most of it is hidden until something breaks.
    bool transparent = false;  ///< Whether light passes: to be drawn after all others.
    int count = 0;             ///< Indices, for glDrawElements.
    const void* offset = nullptr;  ///< Bytes, for glDrawElements.
};

/// Vertices of one body.
struct VertexRange {
    int body = 0;   ///< Index, of WorldDesc::bodies.
    int first = 0;  ///< Its first vertex.
    int count = 0;  ///< How many there are.
};

/// What a Surface has.
struct SurfaceOptions {
    /// Whether each vertex knows the number of its piece: Surface::pieceBuffer(). On a GPU the
    /// state is then copied in every step, as for World::castRay().
    bool pieces = false;
};

/// A texture that the text of Surface::vertexShader() reads.
struct VertexTexture {
    const char* sampler;  ///< The name of its uniform.
    unsigned texture;     ///< Of the target GL_TEXTURE_BUFFER.
};

/// The mesh that is seen of a world, on the GPU: closed pieces whose torn faces fit together. What
/// is between cells that hold together is there, too, as triangles without area.
class SUNDER_API Surface {
  public:
    /// Makes the mesh and puts it on the GPU; update() must be called before it is drawn. `world`
    /// may be simulated on the CPU; then its state is uploaded by every update(). Both must outlive
    /// this. Where it fails, ok() is false.
    Surface(Device& device, World& world, const SurfaceOptions& options = {});
    ~Surface();                                   ///< Before its world.
    Surface(const Surface&) = delete;             ///< It belongs to one world.
    Surface& operator=(const Surface&) = delete;  ///< It belongs to one world.

    /// Whether it can be used.
    bool ok() const;
    /// Why it cannot be used.
    const Error& error() const;

    /// Deforms the mesh as the world is now, as far as it has changed. Reads nothing back and waits
    /// for nothing, where the world is simulated on the GPU. After World::extend() the mesh is made
    /// anew: all names, numbers and ranges are others then.
    Result<void> update();
    /// What the last update() wrote of vertexBuffer(), by body: what sleeps, or is not there, stays
    /// as it was. For hosts that keep something for each vertex, such as shadows or a hierarchy of
    /// boxes.
    std::span<const VertexRange> changed() const;

    /// A vertex array of the device's context with all attributes, at the locations that Vertex and
    /// RestVertex name, and the indices. 0: not ok().
    unsigned vertexArray() const;
    /// Vertex, one after another; to be read, for what is written into it stays until that body
    /// changes. 0: not ok().
    unsigned vertexBuffer() const;
    /// RestVertex, one after another. 0: not ok().
    unsigned restBuffer() const;
    /// With SurfaceOptions::pieces: a 32-bit integer for each vertex, the index in World::pieces()
    /// of the piece that it belongs to, as of World::lookTime() at the last update(), −1 where its
    /// body is not there. Location 9 of vertexArray() and sourceArray(), an integer. 0: not ok(),
    /// or without.
    unsigned pieceBuffer() const;
    /// Indices, unsigned 32-bit, three a triangle, anticlockwise seen from outside. 0: not ok().
    unsigned indexBuffer() const;
    /// How many vertices there are.
    int vertices() const;
    /// What to draw, by material; opaque ones first.
    std::span<const Range> ranges() const;

    // --- Instead of update(): in a vertex shader of the host's own ---

    /// GLSL 4.10, to stand between the line `#version` and the host's own text. It has two inputs,
    /// at locations 0 and 1, five samplers, and `SunderVertex sunderVertex()`, whose result has
    /// what Vertex and RestVertex have: position, normal, tangent, place, texCoord, body, cell,
    /// inside. All its global names begin with sunder, Sunder or SUNDER. It stays the same for this
    /// surface.
    Result<std::string> vertexShader();
    /// What those samplers read, of the world as it is now: to be asked for and bound before each
    /// drawing. Reads nothing back and waits for nothing, where the world is simulated on the GPU.
    Result<std::array<VertexTexture, 5>> vertexTextures();
    /// A vertex array with those inputs and the indices; ranges() are the same. 0: not ok().
    unsigned sourceArray() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sunder::gl
