#pragma once
#include <filesystem>
#include <memory>

namespace sunder::files {

/// Held by one program at a time, and let go when that ends, however it does: the system sees to it
/// (folder_claim_posix.cpp, folder_claim_windows.cpp), and no file tells of it.
class FolderClaim {
  public:
    /// The folder must be there.
    explicit FolderClaim(const std::filesystem::path& folder);
    ~FolderClaim();
    FolderClaim(const FolderClaim&) = delete;
    FolderClaim& operator=(const FolderClaim&) = delete;

    /// False: another has it. True also where the file system knows no such thing.
    bool held() const { return held_; }

  private:
    struct Lock;
    std::unique_ptr<Lock> lock_;
    bool held_;
};

}  // namespace sunder::files
