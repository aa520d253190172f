// Material files: refused in a sentence, or read and written back.
#include "fuzz/fuzzer.hpp"
#include "scene/material_file.hpp"
#include "scene/scene.hpp"
#include "scene/scene_writer.hpp"

using namespace sunder;
using namespace sunder::core;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Material material;
    try {
        material = scene::parseMaterial(fuzz::text(data, size), "fuzz.toml");
    } catch (const InputError& error) {
        fuzz::checkSentence(error);
        return 0;
    }
    const std::string written = scene::writeMaterial(material);
    if (scene::writeMaterial(scene::parseMaterial(written, "fuzz.toml")) != written) std::abort();
    return 0;
}
