#include "gpu/state_dump.hpp"

#include <array>
#include <cstdint>
#include <sstream>
#include <utility>

#include "gl/functions.hpp"

using namespace sunder;

namespace {

struct Name {
    const char* text;
    GLenum value;
};
#define NAME(name) \
    { #name, name }

// Tables 6.5 to 6.61 of GL 4.1, but for what is indexed and what belongs to objects. Values that
// cannot be set are left out.
const Name kPlain[] = {
    // 6.6 to 6.9: vertex arrays
    NAME(GL_VERTEX_ARRAY_BINDING), NAME(GL_PRIMITIVE_RESTART), NAME(GL_PRIMITIVE_RESTART_INDEX),
    NAME(GL_ARRAY_BUFFER_BINDING), NAME(GL_ELEMENT_ARRAY_BUFFER_BINDING),
    NAME(GL_DRAW_INDIRECT_BUFFER_BINDING),
    // 6.11 and 6.12: transformation and colouring
    NAME(GL_DEPTH_CLAMP), NAME(GL_CLAMP_READ_COLOR), NAME(GL_PROVOKING_VERTEX),
    NAME(GL_CLIP_DISTANCE0), NAME(GL_CLIP_DISTANCE1), NAME(GL_CLIP_DISTANCE2),
    NAME(GL_CLIP_DISTANCE3), NAME(GL_CLIP_DISTANCE4), NAME(GL_CLIP_DISTANCE5),
    NAME(GL_CLIP_DISTANCE6), NAME(GL_CLIP_DISTANCE7),
    // 6.13 and 6.14: rasterisation
    NAME(GL_RASTERIZER_DISCARD), NAME(GL_POINT_SIZE), NAME(GL_PROGRAM_POINT_SIZE),
    NAME(GL_POINT_FADE_THRESHOLD_SIZE), NAME(GL_POINT_SPRITE_COORD_ORIGIN), NAME(GL_LINE_WIDTH),
    NAME(GL_LINE_SMOOTH), NAME(GL_CULL_FACE), NAME(GL_CULL_FACE_MODE), NAME(GL_FRONT_FACE),
    NAME(GL_POLYGON_SMOOTH), NAME(GL_POLYGON_MODE), NAME(GL_POLYGON_OFFSET_FACTOR),
    NAME(GL_POLYGON_OFFSET_UNITS), NAME(GL_POLYGON_OFFSET_POINT), NAME(GL_POLYGON_OFFSET_LINE),
    NAME(GL_POLYGON_OFFSET_FILL),
    // 6.15: multisampling
    NAME(GL_MULTISAMPLE), NAME(GL_SAMPLE_ALPHA_TO_COVERAGE), NAME(GL_SAMPLE_ALPHA_TO_ONE),
    NAME(GL_SAMPLE_COVERAGE), NAME(GL_SAMPLE_COVERAGE_VALUE), NAME(GL_SAMPLE_COVERAGE_INVERT),
    NAME(GL_SAMPLE_SHADING), NAME(GL_MIN_SAMPLE_SHADING_VALUE), NAME(GL_SAMPLE_MASK),
    // 6.16 to 6.22: textures
    NAME(GL_ACTIVE_TEXTURE), NAME(GL_TEXTURE_CUBE_MAP_SEAMLESS), NAME(GL_TEXTURE_BUFFER),
    // 6.23: pixel operations
    NAME(GL_STENCIL_TEST), NAME(GL_STENCIL_FUNC), NAME(GL_STENCIL_VALUE_MASK), NAME(GL_STENCIL_REF),
    NAME(GL_STENCIL_FAIL), NAME(GL_STENCIL_PASS_DEPTH_FAIL), NAME(GL_STENCIL_PASS_DEPTH_PASS),
    NAME(GL_STENCIL_BACK_FUNC), NAME(GL_STENCIL_BACK_VALUE_MASK), NAME(GL_STENCIL_BACK_REF),
    NAME(GL_STENCIL_BACK_FAIL), NAME(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
    NAME(GL_STENCIL_BACK_PASS_DEPTH_PASS), NAME(GL_DEPTH_TEST), NAME(GL_DEPTH_FUNC),
    NAME(GL_BLEND_COLOR), NAME(GL_FRAMEBUFFER_SRGB), NAME(GL_DITHER), NAME(GL_COLOR_LOGIC_OP),
    NAME(GL_LOGIC_OP_MODE),
    // 6.24: framebuffer control
    NAME(GL_DEPTH_WRITEMASK), NAME(GL_STENCIL_WRITEMASK), NAME(GL_STENCIL_BACK_WRITEMASK),
    NAME(GL_COLOR_CLEAR_VALUE), NAME(GL_DEPTH_CLEAR_VALUE), NAME(GL_STENCIL_CLEAR_VALUE),
    // 6.25 to 6.27: framebuffers
    NAME(GL_DRAW_FRAMEBUFFER_BINDING), NAME(GL_READ_FRAMEBUFFER_BINDING), NAME(GL_READ_BUFFER),
    NAME(GL_RENDERBUFFER_BINDING), NAME(GL_DRAW_BUFFER0), NAME(GL_DRAW_BUFFER1),
    NAME(GL_DRAW_BUFFER2), NAME(GL_DRAW_BUFFER3), NAME(GL_DRAW_BUFFER4), NAME(GL_DRAW_BUFFER5),
    NAME(GL_DRAW_BUFFER6), NAME(GL_DRAW_BUFFER7),
    // 6.28: pixels
    NAME(GL_UNPACK_SWAP_BYTES), NAME(GL_UNPACK_LSB_FIRST), NAME(GL_UNPACK_IMAGE_HEIGHT),
    NAME(GL_UNPACK_SKIP_IMAGES), NAME(GL_UNPACK_ROW_LENGTH), NAME(GL_UNPACK_SKIP_ROWS),
    NAME(GL_UNPACK_SKIP_PIXELS), NAME(GL_UNPACK_ALIGNMENT), NAME(GL_PACK_SWAP_BYTES),
    NAME(GL_PACK_LSB_FIRST), NAME(GL_PACK_IMAGE_HEIGHT), NAME(GL_PACK_SKIP_IMAGES),
    NAME(GL_PACK_ROW_LENGTH), NAME(GL_PACK_SKIP_ROWS), NAME(GL_PACK_SKIP_PIXELS),
    NAME(GL_PACK_ALIGNMENT), NAME(GL_PIXEL_PACK_BUFFER_BINDING),
    NAME(GL_PIXEL_UNPACK_BUFFER_BINDING),
    // 6.29 to 6.45: shaders, uniforms, transform feedback
    NAME(GL_CURRENT_PROGRAM), NAME(GL_PROGRAM_PIPELINE_BINDING), NAME(GL_UNIFORM_BUFFER_BINDING),
    NAME(GL_TRANSFORM_FEEDBACK_BINDING), NAME(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING),
    NAME(GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE), NAME(GL_TRANSFORM_FEEDBACK_BUFFER_PAUSED),
    NAME(GL_PATCH_VERTICES), NAME(GL_PATCH_DEFAULT_OUTER_LEVEL), NAME(GL_PATCH_DEFAULT_INNER_LEVEL),
    // 6.46 and 6.61: hints and the rest
    NAME(GL_LINE_SMOOTH_HINT), NAME(GL_POLYGON_SMOOTH_HINT), NAME(GL_TEXTURE_COMPRESSION_HINT),
    NAME(GL_FRAGMENT_SHADER_DERIVATIVE_HINT), NAME(GL_COPY_READ_BUFFER),
    NAME(GL_COPY_WRITE_BUFFER)};

// GL 4.2 to 4.6 and extensions, by number where the header of 4.1 does not have the name.
const Name kNewer[] = {{"GL_DEBUG_OUTPUT", 0x92E0},
                       {"GL_DEBUG_OUTPUT_SYNCHRONOUS", 0x8242},
                       {"GL_DEBUG_GROUP_STACK_DEPTH", 0x826D},
                       {"GL_PRIMITIVE_RESTART_FIXED_INDEX", 0x8D69},
                       {"GL_PACK_COMPRESSED_BLOCK_SIZE", 0x912E},
                       {"GL_UNPACK_COMPRESSED_BLOCK_SIZE", 0x912A},
                       {"GL_ATOMIC_COUNTER_BUFFER_BINDING", 0x92C1},
                       {"GL_SHADER_STORAGE_BUFFER_BINDING", 0x90D3},
                       {"GL_DISPATCH_INDIRECT_BUFFER_BINDING", 0x90EF},
                       {"GL_QUERY_BUFFER_BINDING", 0x9193},
                       {"GL_PARAMETER_BUFFER_BINDING", 0x80EF},
                       {"GL_CLIP_ORIGIN", 0x935C},
                       {"GL_CLIP_DEPTH_MODE", 0x935D},
                       {"GL_POLYGON_OFFSET_CLAMP", 0x8E1B},
                       {"GL_WINDOW_RECTANGLE_MODE_EXT", 0x8F13},
                       {"GL_NUM_WINDOW_RECTANGLES_EXT", 0x8F15},
                       {"GL_DEPTH_BOUNDS_TEST_EXT", 0x8890},
                       {"GL_CONSERVATIVE_RASTERIZATION_NV", 0x9346},
                       {"GL_RASTER_MULTISAMPLE_EXT", 0x9327},
                       {"GL_FRAGMENT_COVERAGE_TO_COLOR_NV", 0x92DD},
                       {"GL_SHADING_RATE_IMAGE_NV", 0x9563},
                       {"GL_REPRESENTATIVE_FRAGMENT_TEST_NV", 0x937F},
                       {"GL_SCISSOR_TEST_EXCLUSIVE_NV", 0x9555},
                       {"GL_BLEND_ADVANCED_COHERENT_KHR", 0x9285}};

const Name kCompatibility[] = {{"GL_ALPHA_TEST", 0x0BC0},
                               {"GL_ALPHA_TEST_FUNC", 0x0BC1},
                               {"GL_ALPHA_TEST_REF", 0x0BC2},
                               {"GL_POINT_SMOOTH", 0x0B10},
                               {"GL_POINT_SPRITE", 0x8861},
                               {"GL_POINT_SIZE_MIN", 0x8126},
                               {"GL_POINT_SIZE_MAX", 0x8127},
                               {"GL_POINT_DISTANCE_ATTENUATION", 0x8129},
                               {"GL_POLYGON_STIPPLE", 0x0B42},
                               {"GL_LINE_STIPPLE", 0x0B24},
                               {"GL_SHADE_MODEL", 0x0B54},
                               {"GL_LIGHTING", 0x0B50},
                               {"GL_FOG", 0x0B60},
                               {"GL_CLAMP_VERTEX_COLOR", 0x891A},
                               {"GL_CLAMP_FRAGMENT_COLOR", 0x891B},
                               {"GL_MAP_COLOR", 0x0D10},
                               {"GL_MAP_STENCIL", 0x0D11},
                               {"GL_RED_SCALE", 0x0D14},
                               {"GL_RED_BIAS", 0x0D15},
                               {"GL_GREEN_SCALE", 0x0D18},
                               {"GL_GREEN_BIAS", 0x0D19},
                               {"GL_BLUE_SCALE", 0x0D1A},
                               {"GL_BLUE_BIAS", 0x0D1B},
                               {"GL_ALPHA_SCALE", 0x0D1C},
                               {"GL_ALPHA_BIAS", 0x0D1D},
                               {"GL_DEPTH_SCALE", 0x0D1E},
                               {"GL_DEPTH_BIAS", 0x0D1F},
                               {"GL_MATRIX_MODE", 0x0BA0},
                               {"GL_RENDER_MODE", 0x0C40},
                               {"GL_LIST_INDEX", 0x0B33},
                               {"GL_CLIENT_ACTIVE_TEXTURE", 0x84E1},
                               {"GL_TEXTURE_2D", 0x0DE1},
                               {"GL_CURRENT_COLOR", 0x0B00},
                               {"GL_VERTEX_PROGRAM_TWO_SIDE", 0x8643}};

const Name kOfEachDrawBuffer[] = {NAME(GL_BLEND),
                                  NAME(GL_BLEND_SRC_RGB),
                                  NAME(GL_BLEND_DST_RGB),
                                  NAME(GL_BLEND_SRC_ALPHA),
                                  NAME(GL_BLEND_DST_ALPHA),
                                  NAME(GL_BLEND_EQUATION_RGB),
                                  NAME(GL_BLEND_EQUATION_ALPHA),
                                  NAME(GL_COLOR_WRITEMASK)};
/// GL_NV_viewport_swizzle and GL_NV_scissor_exclusive.
const Name kOfFirstViewport[] = {
    {"GL_VIEWPORT_SWIZZLE_X_NV", 0x9358},     {"GL_VIEWPORT_SWIZZLE_Y_NV", 0x9359},
    {"GL_VIEWPORT_SWIZZLE_Z_NV", 0x935A},     {"GL_VIEWPORT_SWIZZLE_W_NV", 0x935B},
    {"GL_SCISSOR_TEST_EXCLUSIVE_NV", 0x9555}, {"GL_SCISSOR_BOX_EXCLUSIVE_NV", 0x9556}};
const Name kOfEachViewport[] = {NAME(GL_VIEWPORT), NAME(GL_DEPTH_RANGE), NAME(GL_SCISSOR_BOX),
                                NAME(GL_SCISSOR_TEST)};
const Name kOfEachUniformBlock[] = {NAME(GL_UNIFORM_BUFFER_BINDING), NAME(GL_UNIFORM_BUFFER_START),
                                    NAME(GL_UNIFORM_BUFFER_SIZE)};
const Name kOfEachImage[] = {NAME(GL_IMAGE_BINDING_NAME),    NAME(GL_IMAGE_BINDING_LEVEL),
                             NAME(GL_IMAGE_BINDING_LAYERED), NAME(GL_IMAGE_BINDING_LAYER),
                             NAME(GL_IMAGE_BINDING_ACCESS),  NAME(GL_IMAGE_BINDING_FORMAT)};
const Name kOfEachFeedbackBuffer[] = {NAME(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING),
                                      NAME(GL_TRANSFORM_FEEDBACK_BUFFER_START),
                                      NAME(GL_TRANSFORM_FEEDBACK_BUFFER_SIZE)};
const Name kOfEachUnit[] = {NAME(GL_TEXTURE_BINDING_1D),
                            NAME(GL_TEXTURE_BINDING_2D),
                            NAME(GL_TEXTURE_BINDING_3D),
                            NAME(GL_TEXTURE_BINDING_1D_ARRAY),
                            NAME(GL_TEXTURE_BINDING_2D_ARRAY),
                            NAME(GL_TEXTURE_BINDING_RECTANGLE),
                            NAME(GL_TEXTURE_BINDING_BUFFER),
                            NAME(GL_TEXTURE_BINDING_CUBE_MAP),
                            NAME(GL_TEXTURE_BINDING_CUBE_MAP_ARRAY),
                            NAME(GL_TEXTURE_BINDING_2D_MULTISAMPLE),
                            NAME(GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY),
                            NAME(GL_SAMPLER_BINDING)};
const Name kOfEachAttribute[] = {
    NAME(GL_VERTEX_ATTRIB_ARRAY_ENABLED),    NAME(GL_VERTEX_ATTRIB_ARRAY_SIZE),
    NAME(GL_VERTEX_ATTRIB_ARRAY_STRIDE),     NAME(GL_VERTEX_ATTRIB_ARRAY_TYPE),
    NAME(GL_VERTEX_ATTRIB_ARRAY_NORMALIZED), NAME(GL_VERTEX_ATTRIB_ARRAY_INTEGER),
    NAME(GL_VERTEX_ATTRIB_ARRAY_DIVISOR),    NAME(GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING),
    NAME(GL_CURRENT_VERTEX_ATTRIB)};
const Name kQueries[] = {NAME(GL_SAMPLES_PASSED), NAME(GL_ANY_SAMPLES_PASSED),
                         NAME(GL_PRIMITIVES_GENERATED),
                         NAME(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN), NAME(GL_TIME_ELAPSED)};
#undef NAME

/// More numbers than any value has; what a driver leaves as it is cannot differ.
template <class T>
using Numbers = std::array<T, 16>;

template <class T>
std::string text(const Numbers<T>& numbers) {
    std::ostringstream out;
    out.precision(17);
    std::size_t count = numbers.size();
    while (count > 1 && numbers[count - 1] == T(-77)) --count;
    for (std::size_t i = 0; i < count; ++i) out << (i ? " " : "") << numbers[i];
    return out.str();
}

class Dumper {
  public:
    StateDump take() {
        drainErrors();
        for (const Name& name : kPlain) addPlain(name);
        for (const Name& name : kNewer) addPlain(name);
        GLint profile = 0;
        glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
        if (profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT)
            for (const Name& name : kCompatibility) addPlain(name);
        addIndexed(kOfEachDrawBuffer, most(GL_MAX_DRAW_BUFFERS));
        addIndexed(kOfEachViewport, most(GL_MAX_VIEWPORTS));
        addIndexed(kOfFirstViewport, 1);
        addIndexed(kOfEachUniformBlock, most(GL_MAX_UNIFORM_BUFFER_BINDINGS));
        addIndexed(kOfEachFeedbackBuffer, 4);
        addIndexed(kOfEachImage, most(GL_MAX_IMAGE_UNITS));
        const Name sampleMask[] = {{"GL_SAMPLE_MASK_VALUE", GL_SAMPLE_MASK_VALUE}};
        addIndexed(sampleMask, 1);
        addUnits();
        addAttributes();
        addQueries();
        addFramebuffer();
        addDebug();
        return std::move(dump_);
    }

  private:
    static int most(GLenum name) {
        GLint value = 0;
        glGetIntegerv(name, &value);
        drainErrors();  // where there is no such limit
        return value;
    }
    static bool drainErrors() {
        bool any = false;
        for (int i = 0; i < 8 && glGetError() != GL_NO_ERROR; ++i) any = true;
        return any;
    }
    void add(const std::string& name, const std::string& value) {
        if (!drainErrors()) dump_[name] = value;
    }
    /// As integers and as doubles, either of which may round or clamp what it is not made for.
    void addPlain(const Name& name) {
        Numbers<GLint64> integers;
        integers.fill(-77);
        glGetInteger64v(name.value, integers.data());
        add(name.text, text(integers));
        Numbers<GLdouble> doubles;
        doubles.fill(-77);
        glGetDoublev(name.value, doubles.data());
        add(name.text + std::string(" (double)"), text(doubles));
    }
    template <std::size_t Count>
    void addIndexed(const Name (&names)[Count], int count) {
        for (const Name& name : names)
            for (int index = 0; index < count; ++index) {
                const std::string where =
                    name.text + std::string("[") + std::to_string(index) + "]";
                const auto at = static_cast<GLuint>(index);
                Numbers<GLint64> integers;
                integers.fill(-77);
                glGetInteger64i_v(name.value, at, integers.data());
                if (!drainErrors()) dump_[where] = text(integers);
                Numbers<GLint> small;
                small.fill(-77);
                glGetIntegeri_v(name.value, at, small.data());
                add(where + " (int)", text(small));
                Numbers<GLdouble> doubles;
                doubles.fill(-77);
                glGetDoublei_v(name.value, at, doubles.data());
                add(where + " (double)", text(doubles));
                Numbers<GLboolean> booleans;
                booleans.fill(0);
                glGetBooleani_v(name.value, at, booleans.data());
                std::string bits;
                for (const GLboolean bit : booleans) bits += bit ? '1' : '0';
                add(where + " (bool)", bits);
                if (name.value == GL_BLEND || name.value == GL_SCISSOR_TEST)
                    add(where + " (enabled)", glIsEnabledi(name.value, at) ? "1" : "0");
            }
    }
    void addUnits() {
        const int active = most(GL_ACTIVE_TEXTURE);
        const int units = most(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
        for (int unit = 0; unit < units; ++unit) {
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            for (const Name& name : kOfEachUnit) {
                GLint bound = -77;
                glGetIntegerv(name.value, &bound);
                add(name.text + std::string(" of unit ") + std::to_string(unit),
                    std::to_string(bound));
            }
        }
        glActiveTexture(static_cast<GLenum>(active));
    }
    void addAttributes() {
        for (GLuint index = 0; index < static_cast<GLuint>(most(GL_MAX_VERTEX_ATTRIBS)); ++index) {
            for (const Name& name : kOfEachAttribute) {
                Numbers<GLdouble> value;
                value.fill(-77);
                glGetVertexAttribdv(index, name.value, value.data());
                add(name.text + std::string(" of attribute ") + std::to_string(index), text(value));
            }
            void* pointer = nullptr;
            glGetVertexAttribPointerv(index, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
            add("pointer of attribute " + std::to_string(index),
                std::to_string(reinterpret_cast<std::uintptr_t>(pointer)));
        }
    }
    void addQueries() {
        for (const Name& name : kQueries) {
            GLint current = -77;
            glGetQueryiv(name.value, GL_CURRENT_QUERY, &current);
            add(name.text, std::to_string(current));
        }
    }
    /// Of the framebuffer objects that are bound.
    void addFramebuffer() {
        for (const auto& [target, binding] :
             {std::pair{GL_DRAW_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER_BINDING},
              std::pair{GL_READ_FRAMEBUFFER, GL_READ_FRAMEBUFFER_BINDING}}) {
            if (most(static_cast<GLenum>(binding)) == 0) continue;
            const auto bound = static_cast<GLenum>(target);
            for (const GLenum point : {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                       GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT}) {
                GLint kind = -77, name = -77;
                const auto get = [&](GLenum what, GLint* value) {
                    glGetFramebufferAttachmentParameteriv(bound, point, what, value);
                };
                get(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &kind);
                get(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
                add("attachment " + std::to_string(point) + " of " + std::to_string(target),
                    std::to_string(kind) + " " + std::to_string(name));
            }
        }
    }
    /// Whose the debug callback is.
    void addDebug() {
        if (!gl::functions().KHR_debug) return;
        for (const GLenum name : {GL_DEBUG_CALLBACK_FUNCTION, GL_DEBUG_CALLBACK_USER_PARAM}) {
            void* pointer = nullptr;
            glGetPointerv(name, &pointer);
            add("debug callback " + std::to_string(name),
                std::to_string(reinterpret_cast<std::uintptr_t>(pointer)));
        }
    }

    StateDump dump_;
};

}  // namespace

StateDump dumpState() {
    return Dumper().take();
}

std::vector<std::string> differences(const StateDump& before, const StateDump& after) {
    std::vector<std::string> result;
    for (const auto& [name, value] : before) {
        const auto found = after.find(name);
        const std::string now = found == after.end() ? "(none)" : found->second;
        if (now != value) result.push_back(name + ": " + value + " -> " + now);
    }
    for (const auto& [name, value] : after)
        if (!before.count(name)) result.push_back(name + ": (none) -> " + value);
    return result;
}
