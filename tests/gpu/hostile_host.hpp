#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gl/functions.hpp"

namespace hostile {

// Numbers that the header of GL 4.1 core does not have.
inline constexpr GLenum kAlphaTest = 0x0BC0, kPointSmooth = 0x0B10, kPointSprite = 0x8861,
                        kPolygonStipple = 0x0B42, kClampFragmentColour = 0x891B,
                        kPointSizeMin = 0x8126, kPointSizeMax = 0x8127;

inline constexpr GLenum kTargets[11] = {GL_TEXTURE_1D,
                                        GL_TEXTURE_2D,
                                        GL_TEXTURE_3D,
                                        GL_TEXTURE_1D_ARRAY,
                                        GL_TEXTURE_2D_ARRAY,
                                        GL_TEXTURE_RECTANGLE,
                                        GL_TEXTURE_BUFFER,
                                        GL_TEXTURE_CUBE_MAP,
                                        GL_TEXTURE_CUBE_MAP_ARRAY,
                                        GL_TEXTURE_2D_MULTISAMPLE,
                                        GL_TEXTURE_2D_MULTISAMPLE_ARRAY};

inline int integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

}  // namespace hostile

/// A host whose context is in every state that Sunder should not notice. Made and used where its
/// context is current; its objects live as long as that.
class HostileHost {
  public:
    HostileHost();

    struct Setting {
        std::string name;
        void (*set)(HostileHost&);
        /// Where another one would undo or forbid it, it is not among all of them together.
        bool alone = false;
    };
    /// Those that this context has.
    std::vector<Setting> settings() const;
    /// All of them at the same time.
    void setAll();
    /// Everything as in a new context.
    void reset();

    /// The same number as long as nobody has written to the host's buffers and textures.
    std::uint64_t contents();

    GLuint buffer = 0, otherBuffer = 0, vertexArray = 0, program = 0, pipeline = 0, sampler = 0;
    GLuint framebuffer = 0, incomplete = 0, renderbuffer = 0, feedback = 0, query = 0;
    GLuint textures[11] = {};  ///< one of each target
    GLuint plain = 0;          ///< another 2D one
    bool compatibility = false;

  private:
    void makeTextures();
    void makeProgram();
};
