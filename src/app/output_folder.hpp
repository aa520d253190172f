#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "files/folder_claim.hpp"

namespace sunder::app {

/// The folder of --out. It is made where there is none, with those above it, and it is this run's
/// alone: two that write into one folder would leave pictures of both.
class OutputFolder {
  public:
    /// Throws InputError when it cannot be made, or when another run has it. A signal that ends the
    /// program leaves it; see HeldSignals.
    explicit OutputFolder(const std::filesystem::path&);
    /// Folders that were made go again where nothing is in them.
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

  private:
    void make(const std::filesystem::path&);
    void removeEmpty();

    std::vector<std::filesystem::path> made_;  ///< outermost first
    std::unique_ptr<files::FolderClaim> claim_;
};

}  // namespace sunder::app
