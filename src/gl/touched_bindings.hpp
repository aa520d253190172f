#pragma once
#include <array>
#include <bitset>
#include <vector>

#include "gl/functions.hpp"

namespace sunder::gl {

/// What a host has bound to the texture units, uniform blocks and images that Sunder uses, noted
/// when Sunder first uses one during a Visit: most of a context's hundreds of bindings it never
/// does.
class TouchedBindings {
  public:
    enum class Mode {
        Off,      ///< nobody else uses the context
        Cleared,  ///< a host's samplers are taken from the units that Sunder uses
        Noted,    ///< and all is put back in the end
    };
    void begin(Mode mode) { mode_ = mode; }
    /// Before Sunder binds a texture of `target` to `unit`, the active one.
    void texture(int unit, GLenum target) {
        if (mode_ != Mode::Off) note(unit, target);
    }
    /// Before Sunder binds a buffer to the uniform blocks with that binding.
    void uniforms(int binding) {
        if (mode_ == Mode::Noted) note(binding);
    }
    /// Before Sunder binds a texture to the image unit.
    void image(int unit) {
        if (mode_ == Mode::Noted) noteImage(unit);
    }
    /// Puts back what was noted, and ends. Changes the active unit and the generic uniform buffer.
    void end();

    static constexpr int kUnits = 64, kTargets = 4, kUniformBlocks = 16, kImages = 8;

  private:
    void note(int unit, GLenum target);
    void note(int binding);
    void noteImage(int unit);

    struct BoundTexture {
        GLenum unit, target;
        GLuint texture;
    };
    struct BoundSampler {
        GLuint unit, sampler;
    };
    struct BoundUniforms {
        GLuint binding, buffer;
        GLint64 start, size;
    };
    struct BoundImage {
        GLuint unit;
        GLint texture, level, layered, layer, access, format;
    };
    Mode mode_ = Mode::Off;
    std::bitset<kUnits> unitsSeen_;
    std::bitset<kUniformBlocks> blocksSeen_;
    std::bitset<kImages> imagesSeen_;
    std::array<std::bitset<kUnits>, kTargets> texturesSeen_;
    std::vector<BoundTexture> textures_;
    std::vector<BoundSampler> samplers_;
    std::vector<BoundUniforms> uniforms_;
    std::vector<BoundImage> images_;
};

}  // namespace sunder::gl
