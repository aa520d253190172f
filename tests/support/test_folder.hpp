#pragma once
#include <filesystem>
#include <string>

#include "files/temporary_file.hpp"

/// An empty folder, removed at the end.
class TestFolder {
  public:
    TestFolder()
        : path_(sunder::TemporaryFile(std::filesystem::temp_directory_path() / "sunder-test")
                    .path()) {
        std::filesystem::create_directories(path_);
    }
    ~TestFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};
