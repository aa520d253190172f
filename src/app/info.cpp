#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "files/write_file.hpp"
#include "window/context.hpp"

namespace sunder::app {

using namespace core;

namespace {

nlohmann::ordered_json toJson(const gl::DeviceInfo& info) {
    return {{"gl_vendor", info.vendor},
            {"gl_renderer", info.renderer},
            {"gl_version", info.version},
            {"glsl_version", info.glslVersion},
            {"software", info.software},
            {"max_texture_size", info.maxTextureSize},
            {"max_texture_buffer_size", info.maxTextureBufferSize},
            {"max_uniform_block_size", info.maxUniformBlockSize},
            {"max_transform_feedback_components", info.maxTransformFeedbackComponents},
            {"max_geometry_output_components", info.maxGeometryOutputComponents},
            {"max_samples", info.maxSamples}};
}

int info(const std::string& jsonPath) {
    files::checkWritable(jsonPath);
    nlohmann::ordered_json report;
    report["devices"] = nlohmann::ordered_json::array();
    for (const window::DeviceListEntry& entry : window::listDevices()) {
        nlohmann::ordered_json device = {
            {"index", entry.index}, {"description", entry.description}, {"usable", entry.usable}};
        std::cout << (entry.index < 0 ? std::string("-") : std::to_string(entry.index)) << "  "
                  << entry.description << '\n';
        if (entry.usable) {
            device.update(toJson(entry.info));
            std::cout << "   " << entry.info.renderer << ", OpenGL " << entry.info.version << '\n';
        } else {
            device["problem"] = entry.problem;
            std::cout << "   cannot be used: " << entry.problem << '\n';
        }
        report["devices"].push_back(std::move(device));
    }
    int result = kDone;
    try {
        const auto context = window::createHeadlessContext();
        const gl::DeviceInfo& picked = context->info();
        report["picked"] = toJson(picked);
        report["picked"]["device"] = picked.device;
        std::cout << "\nSunder uses " << picked.renderer << " (" << picked.device << ")\n"
                  << "  largest texture        " << picked.maxTextureSize << '\n'
                  << "  largest texture buffer " << picked.maxTextureBufferSize << " texels\n"
                  << "  feedback components    " << picked.maxTransformFeedbackComponents << '\n'
                  << "  samples                " << picked.maxSamples << '\n';
    } catch (const DeviceError& error) {
        std::cerr << "sunder: " << error.what() << '\n';
        report["problem"] = error.what();
        result = kNoContext;
    }
    if (!jsonPath.empty())
        files::writeFile(
            jsonPath, report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    return result;
}

}  // namespace

void addInfo(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("info", "GL devices, drivers and limits");
    auto path = std::make_shared<std::string>();
    command->add_option("--json", *path, "also write it to this file")->type_name("FILE");
    command->callback([&chosen, path] { chosen = [path] { return info(*path); }; });
}

}  // namespace sunder::app
