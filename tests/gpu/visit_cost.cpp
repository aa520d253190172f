// sunder_gpu_tests --visit-cost: what it costs to come into a host's context and to leave it.
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "command.hpp"
#include "gpu/guest.hpp"
#include "gpu/hostile_host.hpp"

using namespace sunder;

namespace {

double medianMicroseconds(gl::Driver& guest, gl::Visit::State state, bool bindings) {
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    std::optional<gl::Texture> texture;
    {
        const gl::Visit visit(guest);
        texture.emplace(gl::makeTexture2D(1, 1, GL_RGBA8, "texel"));
    }
    for (int i = 0; i < 2000; ++i) {
        glFinish();
        const auto start = Clock::now();
        {
            const gl::Visit visit(guest, state);
            // As many as a solver uses in a frame.
            for (int unit = 0; bindings && unit < 33; ++unit)
                gl::bindTexture(unit, GL_TEXTURE_2D, *texture);
        }
        times.push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
    }
    {
        const gl::Visit visit(guest);
        texture.reset();
    }
    std::nth_element(times.begin(), times.begin() + 1000, times.end());
    return times[1000];
}

const Command kVisitCost{
    "--visit-cost", [](const auto&) {
        const auto context = window::createHeadlessContext();
        HostileHost host;
        gl::Driver guest(context->loadFunction(), "a host's", gl::Driver::Owner::Host);
        std::printf("%s\n", context->info().renderer.c_str());
        for (const bool hostile : {false, true}) {
            if (hostile) host.setAll();
            for (const auto& [state, name] : {std::pair{gl::Visit::State::Restored, "restored"},
                                              std::pair{gl::Visit::State::Dirty, "dirty"}})
                for (const bool bindings : {false, true}) {
                    if (hostile && state == gl::Visit::State::Dirty) continue;
                    std::printf("%s host, %s, %s: median %.1f us\n", hostile ? "hostile" : "plain",
                                name, bindings ? "33 textures bound" : "nothing bound",
                                medianMicroseconds(guest, state, bindings));
                }
        }
        host.reset();
    }};

}  // namespace
