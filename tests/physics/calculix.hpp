#pragma once
#include <string>
#include <vector>

#include "physics/joined_mesh.hpp"

/// CalculiX (www.calculix.de), a finite element program that shares nothing with Sunder: linear
/// elasticity on the same mesh, as its elements C3D4. Input and output stay in
/// physics-calculix/NAME of the build folder. Each throws where CalculiX is not installed, or
/// gave no answer.

/// For example "CalculiX 2.20".
std::string calculixVersion();

/// m, per point of the mesh: at rest under `gravity`, m/s².
std::vector<sunder::Vec3> calculixSag(const std::string& name, const JoinedMesh&,
                                      const sunder::Material&, const sunder::Vec3& gravity);

enum class Mass {
    Consistent,  ///< CalculiX's own: the mass matrix that follows from the elements' shape
                 ///< functions
    Lumped,      ///< point masses, JoinedMesh::mass
};

/// Hz, the lowest `count` natural frequencies, ascending.
std::vector<double> calculixFrequencies(const std::string& name, const JoinedMesh&,
                                        const sunder::Material&, int count, Mass);
