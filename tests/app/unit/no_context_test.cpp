// Drivers that are too old, broken or not there: one sentence and exit code 3.
#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"

#ifdef __linux__
TEST_CASE("App: without any EGL driver, or with Mesa's broken, exit code 3") {
    struct Case {
        Workplace::Environment environment;
        std::vector<std::string> said;
    };
    const std::vector<Case> cases{
        {{{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json"}}, {"no usable OpenGL 4.1 context"}},
        {{{"SUNDER_EGL_DEVICE", "nonsense"}}, {"SUNDER_EGL_DEVICE is 'nonsense'"}},
        {{{"GALLIUM_DRIVER", "nonsense"},
          {"SUNDER_EGL_DEVICE", "software"},
          {"EGL_LOG_LEVEL", "fatal"}},
         {"SUNDER_EGL_DEVICE is 'software'", "eglInitialize failed"}},
    };
    const Workplace place;
    place.write("ok.toml", scenes::kFalling);
    for (const Case& c : cases)
        for (const std::vector<std::string>& arguments :
             {std::vector<std::string>{"run", "ok.toml"},
              std::vector<std::string>{"run", "ok.toml", "--solver", "scatter", "--frames-png",
                                       "0"},
              std::vector<std::string>{"bench", "ok.toml", "--quick", "--solvers", "gather"}}) {
            checkRefused(place.run(arguments, c.environment), 3, c.said);
            CHECK(place.contents() == std::set<std::string>{"ok.toml"});
        }
    // What needs no GL goes on without.
    CHECK(place
              .run({"run", "ok.toml", "--solver", "cpu", "--frames-png", "0", "--out", "o"},
                   cases.front().environment)
              .exitCode == 0);
}

TEST_CASE("App: Mesa with OpenGL 4.0 is too old, exit code 3") {
    const Workplace place;
    place.write("ok.toml", scenes::kFalling);
    const Workplace::Environment software{{"MESA_GL_VERSION_OVERRIDE", "4.0"},
                                          {"SUNDER_EGL_DEVICE", "software"}};
    checkRefused(place.run({"run", "ok.toml"}, software), 3,
                 {"the driver offers OpenGL 4.0, Sunder needs 4.1"});
    CHECK(place.contents() == std::set<std::string>{"ok.toml"});
}
#endif
