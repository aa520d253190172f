#include "physics/calculix.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

#include "physics/calculix_answers.hpp"
#include "physics/calculix_process.hpp"

using namespace sunder;
using namespace sunder::core;
namespace fs = std::filesystem;

namespace {

const fs::path kStored = SUNDER_CALCULIX;
/// Of the largest number of an answer. Seven digits are printed, and the last is one unit off where
/// another version or library rounds otherwise in the tenth: ten times that, which is still a
/// thousandth or less of what a test lets pass.
constexpr double kSameAnswer = 1e-5;

/// m, without what rounding leaves of a zero, which the compiler may choose: the input must be the
/// stored one, to the letter, on every system.
double coordinate(double value) {
    return std::round(value * 1e9) / 1e9 + 0.0;  // no zero has a sign
}

/// Mesh, material and anchors of an input file (CalculiX CrunchiX manual, chapter 7). Points and
/// elements count from 1.
std::string model(const JoinedMesh& mesh, const Material& material) {
    std::ostringstream deck;
    deck << std::setprecision(12) << "*NODE, NSET=POINTS\n";
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        deck << i + 1 << ", " << coordinate(mesh.points[i][0]) << ", "
             << coordinate(mesh.points[i][1]) << ", " << coordinate(mesh.points[i][2]) << '\n';
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
    deck << std::setprecision(7);
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

/// The numbers that a test wants of what CalculiX printed.
using Numbers = std::function<std::vector<double>(const std::string& printed)>;

/// The stored ones; they must be to this input, and CalculiX must agree where it is installed.
std::vector<double> answer(PhysicsReport& report, const std::string& name, const std::string& input,
                           const Numbers& numbers) {
    leaveInput(name, input);
    const std::string here = calculixHere();
    const char* update = std::getenv("SUNDER_UPDATE_CALCULIX");
    if (update && (update == name || update == std::string("all"))) {
        if (std::getenv("CI"))
            throw std::runtime_error("answers are never renewed by a CI machine");
        if (here.empty()) throw std::runtime_error("CalculiX's program ccx cannot be run");
        storeAnswer(kStored, name, input, {here, runCalculix(name)});
    }
    const std::vector<double> stored = numbers(storedAnswer(kStored, name, input).printed);
    if (!here.empty())
        report.checkAbsolute("answer to " + name + " asked anew of " + here + ", of the stored one",
                             answerDifference(stored, numbers(runCalculix(name))), 0, "1",
                             kSameAnswer);
    return stored;
}

}  // namespace

std::string calculixVersion(const std::string& name) {
    return storedProgram(kStored, name);
}

double answerDifference(const std::vector<double>& stored, const std::vector<double>& anew) {
    constexpr double kNotComparable = std::numeric_limits<double>::infinity();
    if (stored.size() != anew.size()) return kNotComparable;
    double difference = 0, largest = 0;
    for (std::size_t i = 0; i < stored.size(); ++i) {
        if (!std::isfinite(anew[i])) return kNotComparable;
        difference = std::max(difference, std::abs(anew[i] - stored[i]));
        largest = std::max(largest, std::abs(stored[i]));
    }
    return difference / largest;
}

std::vector<Vec3> calculixSag(PhysicsReport& report, const std::string& name,
                              const JoinedMesh& mesh, const Material& material, const Vec3& gravity,
                              const std::vector<std::size_t>& asked) {
    std::ostringstream deck;
    const Vec3 down = gravity.normalized();
    deck << model(mesh, material) << "*NSET, NSET=ASKED\n";
    for (const std::size_t point : asked) deck << point + 1 << '\n';
    deck << "*STEP\n*STATIC\n*DLOAD\nBODY, GRAV, " << gravity.norm() << ", " << down[0] << ", "
         << down[1] << ", " << down[2] << "\n*NODE PRINT, NSET=ASKED\nU\n*END STEP\n";
    const auto numbers = [&](const std::string& printed) {
        std::istringstream lines = after(printed, "displacements (vx,vy,vz)");
        std::vector<double> sag(3 * mesh.points.size());
        std::size_t point = 0;
        for (std::size_t i = 0; i < asked.size(); ++i) {
            Vec3 u;
            if (!(lines >> point >> u[0] >> u[1] >> u[2]) || point < 1 ||
                point > mesh.points.size())
                throw std::runtime_error("CalculiX did not print every displacement of " + name);
            std::copy_n(u.data(), 3, &sag[3 * (point - 1)]);
        }
        return sag;
    };
    const std::vector<double> flat = answer(report, name, deck.str(), numbers);
    std::vector<Vec3> sag(mesh.points.size());
    for (std::size_t i = 0; i < sag.size(); ++i)
        sag[i] = {flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]};
    return sag;
}

std::vector<double> calculixFrequencies(PhysicsReport& report, const std::string& name,
                                        const JoinedMesh& mesh, const Material& material, int count,
                                        Mass mass) {
    Material solid = material;
    if (mass == Mass::Lumped) solid.density *= 1e-9;  // not zero: the mass matrix is factorised
    const std::string deck = model(mesh, solid) + (mass == Mass::Lumped ? pointMasses(mesh) : "") +
                             "*STEP\n*FREQUENCY\n" + std::to_string(count) + "\n*END STEP\n";
    return answer(report, name, deck, [&](const std::string& printed) {
        std::istringstream lines = after(printed, "E I G E N V A L U E   O U T P U T");
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
    });
}
