#include "gpu/observed_pass.hpp"

namespace sunder::gpu {

using namespace core;

void observe(PassObserver* observer, const char* pass, const TexelTarget& wrote, int count,
             int layers) {
    if (!observer) return;
    for (int layer = 0; layer < layers; ++layer) {
        const std::vector<vec4> texels = wrote.read(layer, {0, count});
        observer->wrote(pass, {&texels[0].x, 4 * texels.size()});
    }
}

void observe(PassObserver* observer, const char* pass, const gl::Framebuffer& wrote, int attachment,
             int width, int count) {
    if (!observer) return;
    const int rows = (count + width - 1) / width;
    std::vector<float> texels(4 * static_cast<std::size_t>(width) * rows);
    glBindFramebuffer(GL_FRAMEBUFFER, wrote.id());
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachment));
    glReadPixels(0, 0, width, rows, GL_RGBA, GL_FLOAT, texels.data());
    observer->wrote(pass, {texels.data(), 4 * static_cast<std::size_t>(count)});
}

void observe(PassObserver* observer, const char* pass, const gl::Buffer& wrote) {
    if (!observer) return;
    std::vector<float> values(wrote.size() / sizeof(float));
    wrote.read(0, wrote.size(), values.data());
    observer->wrote(pass, values);
}

}  // namespace sunder::gpu
