#include <windows.h>

#include <utility>

#include "core/types.hpp"
#include "files/utf16_windows.hpp"
#include "image/fed_process.hpp"

namespace sunder::image {

using namespace core;

struct FedProcess::System {
    std::FILE* input = nullptr;
    std::wstring errorName;
};

namespace {

/// A word for cmd, which reads _wpopen's line. Within quotes it still replaces %NAME%, and nothing
/// hides a quote.
std::string quoted(const std::string& word) {
    if (word.find_first_of("\"%") != std::string::npos)
        throw InputError("'" + word + "' cannot be handed to another program: it has a \" or %");
    return '"' + word + '"';
}

bool isThere(const std::string& program) {
    return SearchPathW(nullptr, files::utf16FromUtf8(program).c_str(), L".exe", 0, nullptr,
                       nullptr) > 0;
}

std::wstring newTemporaryFile() {
    wchar_t folder[MAX_PATH + 1], name[MAX_PATH];
    if (!GetTempPathW(MAX_PATH + 1, folder) || !GetTempFileNameW(folder, L"sun", 0, name))
        throw InputError("there is no folder for temporary files; see the variable TEMP");
    return name;
}

}  // namespace

FedProcess::FedProcess(const std::vector<std::string>& command)
    : system_(std::make_unique<System>()) {
    if (!isThere(command.front())) return;
    std::string line;
    for (const std::string& word : command) line += quoted(word) + ' ';
    system_->errorName = newTemporaryFile();
    // cmd removes the first and the last quote of a line.
    line = '"' + line + ">nul 2>" + quoted(files::utf8FromUtf16(system_->errorName)) + '"';
    system_->input = _wpopen(files::utf16FromUtf8(line).c_str(), L"wb");
    started_ = system_->input != nullptr;
}

FedProcess::~FedProcess() {
    close();
    if (errors_) std::fclose(errors_);
    if (!system_->errorName.empty()) DeleteFileW(system_->errorName.c_str());
}

bool FedProcess::feed(std::string_view bytes) {
    return std::fwrite(bytes.data(), 1, bytes.size(), system_->input) == bytes.size();
}

bool FedProcess::close() {
    if (!system_->input) return false;
    const int status = _pclose(std::exchange(system_->input, nullptr));
    errors_ = _wfopen(system_->errorName.c_str(), L"rb");
    return status == 0;
}

}  // namespace sunder::image
