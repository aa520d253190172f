#include "window/headless_context.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>

namespace sunder::window {

using namespace core;

namespace {

using Candidates = std::vector<HeadlessCandidate>;

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string join(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
    return text;
}

DeviceListEntry tryOut(const HeadlessCandidate& candidate) {
    DeviceListEntry entry{candidate.index, candidate.description, false, {}, {}};
    try {
        entry.info = candidate.open(Profile::Core)->info();
        entry.usable = true;
    } catch (const DeviceError& error) {
        entry.problem = error.what();
    }
    return entry;
}

std::string listing(const Candidates& candidates) {
    std::vector<std::string> lines;
    for (const HeadlessCandidate& candidate : candidates) {
        const DeviceListEntry entry = tryOut(candidate);
        lines.push_back(entry.description + ": " +
                        (entry.usable ? entry.info.renderer : entry.problem));
    }
    return lines.empty() ? "there are no devices" : "the devices are: " + join(lines);
}

[[noreturn]] void failChoice(const std::string& choice, const std::string& why,
                             const Candidates& candidates) {
    throw DeviceError("SUNDER_EGL_DEVICE is '" + choice + "', but " + why + "; " +
                      listing(candidates));
}

bool isIndex(const std::string& choice) {
    return std::all_of(choice.begin(), choice.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::unique_ptr<Context> openIndex(const std::string& choice, const Candidates& candidates,
                                   Profile profile) {
    for (const HeadlessCandidate& candidate : candidates) {
        if (std::to_string(candidate.index) != choice) continue;
        try {
            return candidate.open(profile);
        } catch (const DeviceError& error) {
            failChoice(choice, "that device does not work (" + std::string(error.what()) + ")",
                       candidates);
        }
    }
    failChoice(choice, "no device has that number", candidates);
}

std::unique_ptr<Context> openNamed(const std::string& choice, const Candidates& candidates,
                                   Profile profile) {
    const std::string wanted = lowerCase(choice);
    std::vector<std::string> problems;
    for (const HeadlessCandidate& candidate : candidates) {
        const bool described =
            wanted == "software"
                ? candidate.software
                : lowerCase(candidate.description).find(wanted) != std::string::npos;
        try {
            // Some names are known only to the driver, once it runs.
            std::unique_ptr<Context> context = candidate.open(profile);
            const gl::DeviceInfo& info = context->info();
            const std::string names = lowerCase(info.vendor + '\n' + info.renderer);
            if (described ||
                (wanted == "software" ? info.software : names.find(wanted) != std::string::npos))
                return context;
        } catch (const DeviceError& error) {
            if (described) problems.push_back(candidate.description + ": " + error.what());
        }
    }
    failChoice(choice,
               problems.empty() ? "no device that works goes by that name"
                                : "no device of that name works (" + join(problems) + ")",
               candidates);
}

}  // namespace

std::unique_ptr<Context> createHeadlessContext(Profile profile) {
    Candidates candidates = headlessCandidates();
    std::stable_partition(candidates.begin(), candidates.end(),
                          [](const HeadlessCandidate& candidate) { return !candidate.software; });
    // A candidate without an index is the last resort.
    std::stable_partition(candidates.begin(), candidates.end(),
                          [](const HeadlessCandidate& candidate) { return candidate.index >= 0; });

    const char* variable = std::getenv("SUNDER_EGL_DEVICE");
    const std::string choice = variable ? variable : "";
    if (!choice.empty())
        return isIndex(choice) ? openIndex(choice, candidates, profile)
                               : openNamed(choice, candidates, profile);

    std::vector<std::string> problems;
    for (const HeadlessCandidate& candidate : candidates) {
        try {
            std::unique_ptr<Context> context = candidate.open(profile);
            context->info_.skipped = std::move(problems);
            return context;
        } catch (const DeviceError& error) {
            problems.push_back(candidate.description + ": " + error.what());
        }
    }
    throw DeviceError(
        "no usable OpenGL 4.1 context; tried " +
        (problems.empty() ? "nothing: there are no devices; is a driver, such as Mesa's, installed?"
                          : join(problems)));
}

std::vector<DeviceListEntry> listDevices() {
    std::vector<DeviceListEntry> entries;
    for (const HeadlessCandidate& candidate : headlessCandidates())
        entries.push_back(tryOut(candidate));
    return entries;
}

}  // namespace sunder::window
