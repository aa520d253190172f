#pragma once
#include <Eigen/Core>
#include <stdexcept>

namespace sunder::core {

using Vec3 = Eigen::Vector3d;
using IVec3 = Eigen::Vector3i;
using Mat3 = Eigen::Matrix3d;

/// Wrong use or bad input: one clear sentence for the user (where, what was wrong, what would be
/// right). Exit code 2.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Something is too large for the memory there is: of the machine or of a GPU.
struct MemoryError : InputError {
    using InputError::InputError;
};

/// A device that cannot do what is needed, or was lost. Exit code 3.
struct DeviceError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace sunder::core
