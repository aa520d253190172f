#include <windows.h>

#include <functional>
#include <string>

#include "files/folder_claim.hpp"

namespace sunder::files {

struct FolderClaim::Lock {
    HANDLE mutex = nullptr;
};

FolderClaim::FolderClaim(const std::filesystem::path& folder) : lock_(std::make_unique<Lock>()) {
    // A mutex may have no '\' in its name.
    const std::size_t name = std::hash<std::wstring>()(std::filesystem::canonical(folder).native());
    lock_->mutex =
        CreateMutexW(nullptr, FALSE, (L"Local\\sunder-" + std::to_wstring(name)).c_str());
    held_ = !lock_->mutex || GetLastError() != ERROR_ALREADY_EXISTS;
}

FolderClaim::~FolderClaim() {
    if (lock_->mutex) CloseHandle(lock_->mutex);
}

}  // namespace sunder::files
