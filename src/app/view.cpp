// sunder view: a scene in a window.
#include "app/path_option.hpp"
#include "files/utf8_path.hpp"
#include "view/viewer.hpp"

#include <CLI/CLI.hpp>
#include <tuple>

#include "app/commands.hpp"
#include "app/picture_size.hpp"
#include "files/held_signals.hpp"
#include "files/write_file.hpp"

namespace sunder::app {

void addView(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("view", "A scene in a window, to hit with the mouse");
    auto options = std::make_shared<view::Options>();
    auto size = std::make_shared<std::string>();
    command
        ->add_option("scene", options->scene, "a preset's name (see: sunder list) or a TOML file")
        ->capture_default_str()
        ->type_name("SCENE");
    command->add_option("--solver", options->solver, "see: sunder list (default: as last time)");
    command->add_option("--size", *size, "of the window (default: as last time)")->type_name("WxH");
    addPath(*command, "--out", options->folder,
            "folder for pictures, videos and files that are saved")
        ->default_str(files::utf8FromPath(options->folder))
        ->check(checkFolder, "")
        ->type_name("DIR");
    addPath(*command, "--shader-dir", options->shaders,
            "a copy of glsl/ to take shaders from, again whenever a file changes")
        ->type_name("DIR");
    addPath(*command, "--log", options->log,
            "what happens, as lines of JSON: for tests and bug reports")
        ->type_name("FILE");
    command->callback([&chosen, options, size] {
        chosen = [options, size] {
            if (!size->empty()) std::tie(options->width, options->height) = parsePictureSize(*size);
            files::checkWritable(options->log);
            files::checkWritable(options->folder / "picture.png");
            const int signal = view::view(*options);
            return signal ? files::exitCodeOf(signal) : kDone;
        };
    });
}

}  // namespace sunder::app
