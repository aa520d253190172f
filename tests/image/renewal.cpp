#include "image/renewal.hpp"

#include <algorithm>
#include <set>

#include "cpu/cpu_solver.hpp"
#include "image/stored_state.hpp"

using namespace sunder;
using namespace sunder::core;
namespace fs = std::filesystem;

namespace {

/// Those to be drawn: only baselines of their own can be renewed.
std::vector<SuitePicture> chosen(const Suite& suite, const fs::path& folder,
                                 const Renewal& renewal) {
    std::vector<SuitePicture> pictures = suite.pictures;
    std::erase_if(pictures, [](const SuitePicture& picture) { return !picture.ownBaseline(); });
    if (renewal.only.empty()) return pictures;
    const SuitePicture& wanted = suite.picture(renewal.only);
    if (!wanted.ownBaseline())
        throw InputError("'" + wanted.name + "' has no baseline of its own but that of '" +
                         wanted.baseline + "'");
    const auto sameState = [&](const SuitePicture& picture) {
        return renewal.states && picture.storedState() && wanted.storedState() &&
               stateOf(folder, picture) == stateOf(folder, wanted);
    };
    std::erase_if(pictures, [&](const SuitePicture& picture) {
        return picture.name != wanted.name && !sameState(picture);
    });
    return pictures;
}

State simulate(const SuitePicture& picture) {
    const scene::Scene scene = scene::loadScene(picture.scene);
    const World world(scene.world);
    cpu::CpuSolver solver(world);
    solver.advance(scene.substeps * picture.frame);
    return solver.state();
}

}  // namespace

std::string renewalRefused(const Suite& suite, const gl::DeviceInfo& device, bool ci) {
    if (ci) return "baselines are never renewed by a CI machine";
    if (!suite.madeBaselines(device))
        return "baselines are made with " + suite.baselineRenderer + "…, " + suite.baselineVersion +
               ", not with " + device.renderer + ", OpenGL " + device.version;
    return {};
}

std::vector<fs::path> renew(const Suite& suite, const fs::path& folder,
                            const gl::DeviceInfo& device, const Renewal& renewal) {
    const std::string refused = renewalRefused(suite, device, renewal.ci);
    if (!refused.empty()) throw InputError(refused);
    std::vector<fs::path> written;
    std::set<fs::path> fresh;
    for (const SuitePicture& picture : chosen(suite, folder, renewal)) {
        const fs::path state = stateOf(folder, picture);
        if (picture.storedState() && !fresh.count(state) &&
            (renewal.states || !fs::exists(state))) {
            writeState(state, simulate(picture));
            fresh.insert(state);
            written.push_back(state);
        }
        fs::create_directories(folder / "baselines");
        written.push_back(baselineOf(folder, picture));
        image::writePng(written.back(), drawSuitePicture(picture, folder));
    }
    return written;
}
