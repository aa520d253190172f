#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "files/folder_claim.hpp"

namespace sunder::files {

struct FolderClaim::Lock {
    int folder = -1;
};

FolderClaim::FolderClaim(const std::filesystem::path& folder) : lock_(std::make_unique<Lock>()) {
    lock_->folder = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    held_ =
        lock_->folder < 0 || flock(lock_->folder, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

FolderClaim::~FolderClaim() {
    if (lock_->folder >= 0) close(lock_->folder);
}

}  // namespace sunder::files
