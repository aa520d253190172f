#include "scene/vtu.hpp"

#include <charconv>

#include "core/diagnostics.hpp"
#include "core/pieces.hpp"
#include "core/tetrahedra.hpp"

namespace sunder::scene {

using namespace core;

namespace {

/// Text with shortest-form numbers, independent of the locale.
class VtuWriter {
  public:
    explicit VtuWriter(std::size_t expected) { text_.reserve(expected); }
    void raw(std::string_view s) { text_ += s; }
    template <class T>
    void number(T value, char after = ' ') {
        char buffer[32];
        const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
        text_.append(buffer, end);
        text_ += after;
    }
    void vector(const Vec3& v) {
        for (int i = 0; i < 3; ++i) number(static_cast<float>(v[i]), i == 2 ? '\n' : ' ');
    }
    void open(std::string_view type, std::string_view name, int components = 1) {
        raw("<DataArray type=\"");
        raw(type);
        raw("\" Name=\"");
        raw(name);
        raw("\" format=\"ascii\"");
        if (components > 1) {
            raw(" NumberOfComponents=\"");
            number(components, '"');
        }
        raw(">\n");
    }
    void close() { raw("</DataArray>\n"); }
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

}  // namespace

std::string toVtu(const World& world, const State& state) {
    std::vector<int> cells;
    for (int cell = 0; cell < world.cellCount(); ++cell)
        if (world.present(cell, state)) cells.push_back(cell);
    const auto points = kCorners * cells.size(), tetrahedra = kTetrahedraPerCell * cells.size();
    VtuWriter w(points * 120 + tetrahedra * 60 + 4096);

    const auto perPoint = [&](std::string_view name, auto&& value) {
        w.open("Float32", name, 3);
        for (const int cell : cells)
            for (int corner = 0; corner < kCorners; ++corner)
                w.vector(value(kCorners * cell + corner));
        w.close();
    };
    const auto perCell = [&](std::string_view type, std::string_view name, auto&& value) {
        w.open(type, name);
        for (const int cell : cells) {
            const auto v = value(cell);
            for (int t = 0; t < kTetrahedraPerCell; ++t) w.number(v, t == 4 ? '\n' : ' ');
        }
        w.close();
    };

    w.raw(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
        "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"");
    w.number(points, '"');
    w.raw(" NumberOfCells=\"");
    w.number(tetrahedra, '"');
    w.raw(">\n<Points>\n");
    perPoint("Points",
             [&](int node) -> Vec3 { return world.restPosition(node) + state.displacement[node]; });
    w.raw("</Points>\n<Cells>\n");
    w.open("Int64", "connectivity");
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (const Tetrahedron& tet : kTetrahedra[world.parity(cells[i])]) {
            for (const int corner : tet) w.number(kCorners * i + corner);
            w.raw("\n");
        }
    w.close();
    w.open("Int64", "offsets");
    for (std::size_t t = 1; t <= tetrahedra; ++t) w.number(4 * t, '\n');
    w.close();
    w.open("UInt8", "types");
    for (std::size_t t = 0; t < tetrahedra; ++t) w.raw("10\n");
    w.close();
    w.raw("</Cells>\n<PointData>\n");
    perPoint("displacement", [&](int node) { return state.displacement[node]; });
    perPoint("velocity", [&](int node) { return state.velocity[node]; });
    w.raw("</PointData>\n<CellData>\n");
    const Pieces pieces = findPieces(world, state);
    perCell("Int32", "material",
            [&](int cell) { return world.laws()[world.lawOf(cell)].material; });
    perCell("Float32", "max_principal_stress",
            [&](int cell) { return static_cast<float>(cellPrincipalStress(world, state, cell)); });
    perCell("Int32", "piece", [&](int cell) { return pieces.ofCell[cell]; });
    w.raw("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    return w.take();
}

}  // namespace sunder::scene
