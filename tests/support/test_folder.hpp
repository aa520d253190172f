#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "files/temporary_file.hpp"

/// An empty folder, removed at the end.
class TestFolder {
  public:
    TestFolder()
        : path_(sunder::files::TemporaryFile(std::filesystem::temp_directory_path() / "sunder-test")
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

/// Of a whole file; empty where there is none.
inline std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}
