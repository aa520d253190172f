#pragma once
#include <vector>

#include "cpu/cpu_contact.hpp"
#include "cpu/objects.hpp"

namespace sunder::cpu {

/// The nodes as objects see them.
class ObjectCells : public Objects::Cells {
  public:
    /// `bodies`: all of the world's, in its order. All three must outlive it.
    ObjectCells(const core::World& world, std::vector<const BodyArrays*> bodies,
                const Contact& contact);

    Bounds bounds(int body) const override;
    core::CellMotion motion(int cell) const override;
    std::uint8_t links(int cell, int corner) const override;
    void push(int cell, const std::array<double, core::kCorners>& weights,
              const core::Vec3& force) override;

  private:
    struct Place {
        const BodyArrays* arrays;
        int cell;  ///< in them
    };
    Place placeOf(int cell) const;

    const core::World& world_;
    std::vector<const BodyArrays*> bodies_;
    const Contact& contact_;
};

}  // namespace sunder::cpu
