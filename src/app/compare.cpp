// sunder compare: are two pictures alike, as a person would say?
#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/bench_table.hpp"
#include "app/commands.hpp"
#include "app/number_check.hpp"
#include "app/output_path.hpp"
#include "app/path_option.hpp"
#include "core/types.hpp"
#include "files/utf8_path.hpp"
#include "files/write_file.hpp"
#include "image/comparison.hpp"

namespace sunder::app {
namespace {

struct CompareOptions {
    std::filesystem::path first, second, json, difference;
    image::ComparisonLimits limits;
};

std::string percent(double share) {
    return shortNumber(100 * share) + " %";
}

std::string toJson(const CompareOptions& options, const image::Image& a,
                   const image::Comparison& c) {
    const nlohmann::ordered_json report = {{"alike", c.alike(options.limits)},
                                           {"width", a.width},
                                           {"height", a.height},
                                           {"share", c.share},
                                           {"mean", c.mean},
                                           {"largest", c.largest},
                                           {"worst_window",
                                            {{"x", c.windowX},
                                             {"y", c.windowY},
                                             {"width", c.windowWidth},
                                             {"height", c.windowHeight},
                                             {"share", c.windowShare}}},
                                           {"limits",
                                            {{"threshold", options.limits.threshold},
                                             {"share", options.limits.share},
                                             {"window", options.limits.window},
                                             {"mean", options.limits.mean}}}};
    return report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

int compareFiles(const CompareOptions& options) {
    checkOutputs({{"--json", options.json}, {"--diff", options.difference}});
    const image::Image a = image::readPng(options.first), b = image::readPng(options.second);
    if (a.width != b.width || a.height != b.height) {
        std::cout << "different: " << files::utf8FromPath(options.first) << " has " << a.width
                  << " x " << a.height << " pixels, " << files::utf8FromPath(options.second)
                  << " has " << b.width << " x " << b.height << '\n';
        if (!options.json.empty())
            files::writeFile(
                options.json,
                nlohmann::ordered_json{{"alike", false},
                                       {"sizes", {{a.width, a.height}, {b.width, b.height}}}}
                        .dump(2) +
                    "\n");
        return kDifferent;
    }
    const image::ComparisonLimits& limits = options.limits;
    const image::Comparison c = image::compare(a, b, limits.threshold);
    const bool alike = c.alike(limits);
    std::cout << (alike ? "alike" : "different") << ": " << percent(c.share)
              << " of the pixels differ by more than " << limits.threshold << " of 255 ("
              << percent(limits.share) << " may), up to " << percent(c.windowShare)
              << " in a window of " << c.windowWidth << " x " << c.windowHeight << " at "
              << c.windowX << ", " << c.windowY << " (" << percent(limits.window)
              << "); mean difference " << shortNumber(c.mean) << " (" << shortNumber(limits.mean)
              << "), largest " << c.largest << '\n';
    if (!options.json.empty()) files::writeFile(options.json, toJson(options, a, c));
    if (!options.difference.empty())
        image::writePng(options.difference, image::differencePicture(a, b, c));
    return alike ? kDone : kDifferent;
}

}  // namespace

void addCompare(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand(
        "compare", "Whether two pictures are alike: exit code 0, or 1 where they are not");
    auto options = std::make_shared<CompareOptions>();
    addPath(*command, "a", options->first, "a picture")->required()->type_name("A.png");
    addPath(*command, "b", options->second, "another")->required()->type_name("B.png");
    image::ComparisonLimits& limits = options->limits;
    command
        ->add_option("--threshold", limits.threshold,
                     "levels, 0 to 255, by which a channel of a pixel may differ")
        ->check(wholeNumber(0, 255))
        ->capture_default_str();
    command->add_option("--share", limits.share, "share of all pixels that may differ, 0 to 1")
        ->check(number(0, 1))
        ->capture_default_str();
    command
        ->add_option("--window", limits.window,
                     "share of the pixels in any window of 16 x 16 that may differ, 0 to 1")
        ->check(number(0, 1))
        ->capture_default_str();
    command->add_option("--mean", limits.mean, "mean difference allowed, levels, 0 to 255")
        ->check(number(0, 255))
        ->capture_default_str();
    addPath(*command, "--json", options->json, "write the figures to this file")->type_name("FILE");
    addPath(*command, "--diff", options->difference,
            "write a picture of the differences, times 16, the worst window framed")
        ->type_name("FILE.png");
    command->callback(
        [&chosen, options] { chosen = [options] { return compareFiles(*options); }; });
}

}  // namespace sunder::app
