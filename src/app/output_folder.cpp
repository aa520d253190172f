#include "app/output_folder.hpp"

#include <algorithm>
#include <functional>
#include <string>

#include "core/types.hpp"

#ifdef _WIN32
#include <windows.h>
#else
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#endif

namespace sunder::app {

namespace fs = std::filesystem;

/// Held by one program at a time, and let go when that ends, however it does: the system sees to
/// it, and no file tells of it.
class OutputFolder::Claim {
  public:
    explicit Claim(const fs::path& folder) {
        if (!take(folder))
            throw InputError("--out: another `sunder run` is writing into '" + folder.string() +
                             "'; give this one a folder of its own");
    }
    Claim(const Claim&) = delete;
    Claim& operator=(const Claim&) = delete;

#ifdef _WIN32
    ~Claim() {
        if (mutex_) CloseHandle(mutex_);
    }

  private:
    bool take(const fs::path& folder) {
        const std::size_t name = std::hash<std::string>()(fs::canonical(folder).string());
        mutex_ = CreateMutexA(nullptr, FALSE, ("Local\\sunder-" + std::to_string(name)).c_str());
        return !mutex_ || GetLastError() != ERROR_ALREADY_EXISTS;
    }

    HANDLE mutex_ = nullptr;
#else
    ~Claim() {
        if (folder_ >= 0) close(folder_);
    }

  private:
    /// True also where the file system knows no such thing.
    bool take(const fs::path& folder) {
        folder_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        return folder_ < 0 || flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    }

    int folder_ = -1;
#endif
};

OutputFolder::OutputFolder(const fs::path& path) {
    try {
        make(path);
        claim_ = std::make_unique<Claim>(path);
    } catch (...) {
        removeEmpty();
        throw;
    }
}

OutputFolder::~OutputFolder() {
    removeEmpty();
}

void OutputFolder::make(const fs::path& path) {
    std::error_code error;
    std::vector<fs::path> missing;
    for (fs::path p = path; !p.empty() && !fs::is_directory(p, error); p = p.parent_path())
        missing.push_back(p);
    std::reverse(missing.begin(), missing.end());
    for (const fs::path& folder : missing) {
        if (fs::create_directory(folder, error)) made_.push_back(folder);
        if (error)
            throw InputError("--out: cannot make the folder '" + path.string() +
                             "': " + error.message());
    }
}

void OutputFolder::removeEmpty() {
    std::error_code ignored;
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder)
        fs::remove(*folder, ignored);
}

}  // namespace sunder::app
