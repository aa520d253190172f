#pragma once
// How guest_state.cpp writes its tables, and what is done with them.
#include <array>
#include <cstddef>

#include "gl/driver.hpp"

namespace sunder::gl {

/// What a piece of state has to do with Sunder.
enum Cause : unsigned {
    kDepends = 1,  ///< results would depend on it: neutral during a visit
    kChanges = 2,  ///< some pass sets it: put back after a visit, even where it was neutral
};

/// What a context must have for a piece of state to be there.
struct Needs {
    int Functions::*extension = nullptr;
    bool compatibility = false;

    bool metBy(Driver& driver) const {
        return (!extension || driver.functions().*extension) &&
               (!compatibility || driver.info().compatibility);
    }
};
inline constexpr Needs kCompatibility{nullptr, true};

/// Of glEnable and glDisable.
struct Capability {
    GLenum name;
    bool neutral;
    unsigned cause;
    Needs needs = {};
};

/// Of glGetIntegerv, glGetFloatv or glGetDoublev: up to four numbers.
template <class T>
struct Value {
    GLenum name;
    std::array<T, 4> neutral;  ///< as in a new context
    unsigned cause;
    void (*set)(const T*);
    Needs needs = {};
};

// Of the compatibility profile, which the header of the core profile leaves out.
inline constexpr GLenum kAlphaTest = 0x0BC0, kPointSmooth = 0x0B10, kPointSprite = 0x8861,
                        kPolygonStipple = 0x0B42, kClampVertexColour = 0x891A,
                        kClampFragmentColour = 0x891B, kPointSizeMin = 0x8126,
                        kPointSizeMax = 0x8127, kPointAttenuation = 0x8129, kMapColour = 0x0D10,
                        kScale[] = {0x0D14, 0x0D18, 0x0D1A, 0x0D1C},
                        kBias[] = {0x0D15, 0x0D19, 0x0D1B, 0x0D1D}, kRenderMode = 0x0C40,
                        kRender = 0x1C00, kListIndex = 0x0B33;

inline void setCapability(GLenum name, bool on) {
    if (on)
        glEnable(name);
    else
        glDisable(name);
}

inline void get(GLenum name, GLint* value) {
    glGetIntegerv(name, value);
}
inline void get(GLenum name, GLfloat* value) {
    glGetFloatv(name, value);
}
inline void get(GLenum name, GLdouble* value) {
    glGetDoublev(name, value);
}

template <std::size_t Count>
class SavedCapabilities {
  public:
    explicit SavedCapabilities(const Capability (&rows)[Count]) : rows_(rows) {}
    void save(Driver& driver) {
        for (std::size_t i = 0; i < Count; ++i)
            before_[i] =
                rows_[i].needs.metBy(driver) ? glIsEnabled(rows_[i].name) != 0 : rows_[i].neutral;
    }
    void neutralise(Driver&) {
        for (std::size_t i = 0; i < Count; ++i)
            if ((rows_[i].cause & kDepends) && before_[i] != rows_[i].neutral)
                setCapability(rows_[i].name, rows_[i].neutral);
    }
    void neutraliseAll(Driver& driver) {
        for (const Capability& row : rows_)
            if ((row.cause & kDepends) && row.needs.metBy(driver))
                setCapability(row.name, row.neutral);
    }
    void restore(Driver& driver) {
        for (std::size_t i = 0; i < Count; ++i)
            if (((rows_[i].cause & kChanges) && rows_[i].needs.metBy(driver)) ||
                before_[i] != rows_[i].neutral)
                setCapability(rows_[i].name, before_[i]);
    }

  private:
    const Capability (&rows_)[Count];
    std::array<bool, Count> before_{};
};

template <class T, std::size_t Count>
class SavedValues {
  public:
    explicit SavedValues(const Value<T> (&rows)[Count]) : rows_(rows) {}
    void save(Driver& driver) {
        for (std::size_t i = 0; i < Count; ++i) {
            before_[i] = rows_[i].neutral;  // also what a driver leaves out
            if (rows_[i].needs.metBy(driver)) get(rows_[i].name, before_[i].data());
        }
    }
    void neutralise(Driver&) {
        for (std::size_t i = 0; i < Count; ++i)
            if ((rows_[i].cause & kDepends) && before_[i] != rows_[i].neutral)
                rows_[i].set(rows_[i].neutral.data());
    }
    void neutraliseAll(Driver& driver) {
        for (const Value<T>& row : rows_)
            if ((row.cause & kDepends) && row.needs.metBy(driver)) row.set(row.neutral.data());
    }
    void restore(Driver& driver) {
        for (std::size_t i = 0; i < Count; ++i)
            if (((rows_[i].cause & kChanges) && rows_[i].needs.metBy(driver)) ||
                before_[i] != rows_[i].neutral)
                rows_[i].set(before_[i].data());
    }

  private:
    const Value<T> (&rows_)[Count];
    std::array<std::array<T, 4>, Count> before_{};
};

}  // namespace sunder::gl
