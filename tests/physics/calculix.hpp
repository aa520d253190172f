#pragma once
#include <string>
#include <vector>

#include "physics/joined_mesh.hpp"
#include "physics/report.hpp"

/// CalculiX (www.calculix.de), a finite element program that shares nothing with Sunder: linear
/// elasticity on the same mesh, as its elements C3D4. The answers are those stored in
/// tests/physics/calculix, and each throws where there is none to this input. Where CalculiX is
/// installed it is asked anew, and a figure of the report says whether it agrees. Input and output
/// stay in physics-calculix/NAME of the build folder.
///
/// While SUNDER_UPDATE_CALCULIX is NAME or `all`, CalculiX is asked and its answer stored instead:
/// tools/update-calculix.

/// Whose answer is stored, for example "CalculiX 2.20".
std::string calculixVersion(const std::string& name);

/// m, per point of the mesh: at rest under `gravity`, m/s². Zero but at those that `asked` names.
std::vector<sunder::core::Vec3> calculixSag(PhysicsReport&, const std::string& name,
                                            const JoinedMesh&, const sunder::core::Material&,
                                            const sunder::core::Vec3& gravity,
                                            const std::vector<std::size_t>& asked);

enum class Mass {
    Consistent,  ///< CalculiX's own: the mass matrix that follows from the elements' shape
                 ///< functions
    Lumped,      ///< point masses, JoinedMesh::mass
};

/// Hz, the lowest `count` natural frequencies, ascending.
std::vector<double> calculixFrequencies(PhysicsReport&, const std::string& name, const JoinedMesh&,
                                        const sunder::core::Material&, int count, Mass);

/// The largest difference between two answers, as a share of the largest number in the first.
/// Infinite where they are not of the same length or the second has what is no number.
double answerDifference(const std::vector<double>& stored, const std::vector<double>& anew);
