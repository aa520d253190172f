#include "app/support/vtu_file.hpp"

#include <sstream>
#include <stdexcept>

#include "app/support/xml_reader.hpp"

namespace {

using Attributes = XmlReader::Attributes;

std::vector<double> numbersIn(const std::string& text) {
    std::vector<double> numbers;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        std::size_t used = 0;
        numbers.push_back(std::stod(word, &used));
        if (used != word.size()) throw std::runtime_error("'" + word + "' is not a number");
    }
    return numbers;
}

struct VtuBuilder {
    VtuFile file;
    VtuArray* current = nullptr;

    void open(const std::string& name, const Attributes& attributes,
              const std::vector<std::string>& parents) {
        current = nullptr;
        if (name == "VTKFile" && attributes.at("type") != "UnstructuredGrid")
            throw std::runtime_error("not an unstructured grid");
        if (name == "Piece") {
            file.points = std::stoi(attributes.at("NumberOfPoints"));
            file.cells = std::stoi(attributes.at("NumberOfCells"));
        }
        if (name != "DataArray") return;
        const std::vector<std::string> wanted{"VTKFile", "UnstructuredGrid", "Piece"};
        if (parents.size() != 4 || !std::equal(wanted.begin(), wanted.end(), parents.begin()))
            throw std::runtime_error("a DataArray at the wrong place");
        if (attributes.at("format") != "ascii") throw std::runtime_error("an array is not text");
        const auto [entry, isNew] = file.arrays.try_emplace(attributes.at("Name"));
        if (!isNew) throw std::runtime_error(entry->first + " twice");
        current = &entry->second;
        current->section = parents.back();
        current->type = attributes.at("type");
        if (attributes.count("NumberOfComponents"))
            current->components = std::stoi(attributes.at("NumberOfComponents"));
    }
    void text(const std::string& characters) {
        if (!current) throw std::runtime_error("text outside of a DataArray");
        current->values = numbersIn(characters);
    }
};

}  // namespace

VtuFile parseVtu(const std::string& text) {
    VtuBuilder builder;
    XmlReader(text).read(builder);
    return builder.file;
}
