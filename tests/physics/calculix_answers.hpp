#pragma once
#include <filesystem>
#include <string>

/// What CalculiX printed for an input, as tests/physics/calculix has it in NAME.dat, behind one
/// line that says which version it was, how it was run, and what the input was. An input of up to
/// 100 kB is stored beside it, in NAME.inp. tools/update-calculix makes both.
struct CalculixAnswer {
    std::string program;  ///< for example "CalculiX 2.20"
    std::string printed;
};

/// Of the one that is stored, whatever the input; throws where none is.
std::string storedProgram(const std::filesystem::path& folder, const std::string& name);

/// Throws where there is none, or where it answers another input; the message says what to do.
CalculixAnswer storedAnswer(const std::filesystem::path& folder, const std::string& name,
                            const std::string& input);

void storeAnswer(const std::filesystem::path& folder, const std::string& name,
                 const std::string& input, const CalculixAnswer&);
