#include "physics/calculix.hpp"

#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>
#include <stdexcept>

#include "physics/calculix_process.hpp"

using namespace sunder;

namespace {

/// Mesh, material and anchors of an input file (CalculiX CrunchiX manual, chapter 7). Points and
/// elements count from 1.
std::string model(const JoinedMesh& mesh, const Material& material) {
    std::ostringstream deck;
    deck << std::setprecision(12) << "*NODE, NSET=POINTS\n";
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        deck << i + 1 << ", " << mesh.points[i][0] << ", " << mesh.points[i][1] << ", "
             << mesh.points[i][2] << '\n';
    deck << "*ELEMENT, TYPE=C3D4, ELSET=BODY\n";
    for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
        deck << i + 1;
        for (const int point : mesh.tetrahedra[i]) deck << ", " << point + 1;
        deck << '\n';
    }
    deck << "*MATERIAL, NAME=ELASTIC\n*ELASTIC\n"
         << material.youngModulus << ", " << material.poissonRatio << "\n*DENSITY\n"
         << material.density << "\n*SOLID SECTION, ELSET=BODY, MATERIAL=ELASTIC\n*BOUNDARY\n";
    for (std::size_t i = 0; i < mesh.anchored.size(); ++i)
        if (mesh.anchored[i]) deck << i + 1 << ", 1, 3\n";
    return deck.str();
}

/// An element of type MASS at every point, in a set for each of the few masses there are.
std::string pointMasses(const JoinedMesh& mesh) {
    std::map<float, std::vector<std::size_t>> points;  // sums of equal masses, in other orders
    for (std::size_t i = 0; i < mesh.mass.size(); ++i)
        points[static_cast<float>(mesh.mass[i])].push_back(i + 1);
    std::ostringstream deck;
    deck << std::setprecision(12);
    std::size_t element = mesh.tetrahedra.size(), set = 0;
    for (const auto& [mass, members] : points) {
        deck << "*ELEMENT, TYPE=MASS, ELSET=MASS" << ++set << '\n';
        for (const std::size_t point : members) deck << ++element << ", " << point << '\n';
        deck << "*MASS, ELSET=MASS" << set << '\n' << mass << '\n';
    }
    return deck.str();
}

/// Lines of the output after the one that contains `heading`.
std::istringstream after(const std::string& output, const std::string& heading) {
    const std::size_t at = output.find(heading);
    if (at == std::string::npos) throw std::runtime_error("CalculiX printed no '" + heading + "'");
    return std::istringstream(output.substr(output.find('\n', at)));
}

}  // namespace

std::vector<Vec3> calculixSag(const std::string& name, const JoinedMesh& mesh,
                              const Material& material, const Vec3& gravity) {
    std::ostringstream deck;
    const Vec3 down = gravity.normalized();
    deck << model(mesh, material) << "*STEP\n*STATIC\n*DLOAD\nBODY, GRAV, " << gravity.norm()
         << ", " << down[0] << ", " << down[1] << ", " << down[2]
         << "\n*NODE PRINT, NSET=POINTS\nU\n*END STEP\n";
    const std::string output = runCalculix(name, deck.str());
    std::istringstream lines = after(output, "displacements (vx,vy,vz)");
    std::vector<Vec3> sag(mesh.points.size());
    std::size_t point = 0;
    for (std::size_t i = 0; i < sag.size(); ++i) {
        Vec3 u;
        if (!(lines >> point >> u[0] >> u[1] >> u[2]) || point < 1 || point > sag.size())
            throw std::runtime_error("CalculiX did not print every displacement of " + name);
        sag[point - 1] = u;
    }
    return sag;
}

std::vector<double> calculixFrequencies(const std::string& name, const JoinedMesh& mesh,
                                        const Material& material, int count, Mass mass) {
    Material solid = material;
    if (mass == Mass::Lumped) solid.density *= 1e-9;  // not zero: the mass matrix is factorised
    const std::string deck = model(mesh, solid) + (mass == Mass::Lumped ? pointMasses(mesh) : "") +
                             "*STEP\n*FREQUENCY\n" + std::to_string(count) + "\n*END STEP\n";
    std::istringstream lines = after(runCalculix(name, deck), "E I G E N V A L U E   O U T P U T");
    std::vector<double> frequencies;
    std::string line;
    while (static_cast<int>(frequencies.size()) < count && std::getline(lines, line)) {
        // Mode, eigenvalue, rad/s, Hz, imaginary part. Headings are words.
        std::istringstream columns(line);
        double mode, eigenvalue, radians, hertz;
        if (columns >> mode >> eigenvalue >> radians >> hertz) frequencies.push_back(hertz);
    }
    if (static_cast<int>(frequencies.size()) < count)
        throw std::runtime_error("CalculiX found too few frequencies of " + name);
    return frequencies;
}
