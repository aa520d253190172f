#pragma once
#include <map>
#include <string>
#include <vector>

/// One DataArray of a VTK XML file.
struct VtuArray {
    std::string section;  ///< the element around it: Points, Cells, PointData or CellData
    std::string type;
    int components = 1;
    std::vector<double> values;
};

struct VtuFile {
    int points = 0, cells = 0;
    std::map<std::string, VtuArray> arrays;
};

/// Reads an unstructured grid of one piece, all of it text. Throws std::runtime_error where the
/// text is not well-formed XML, or is no such file.
VtuFile parseVtu(const std::string& text);
