#pragma once
#include <memory>

namespace sunder::gl {

class Driver;

/// The state of a host's context that Sunder's results depend on or that Sunder changes: all but
/// the textures, samplers and uniform blocks, of which TouchedBindings takes care. Its tables, and
/// what is not in them, are in guest_state.cpp.
class GuestState {
  public:
    explicit GuestState(Driver&);
    ~GuestState();
    GuestState(const GuestState&) = delete;
    GuestState& operator=(const GuestState&) = delete;

    /// Throws InputError, one sentence, when the host is in the midst of something that can be
    /// neither interrupted nor left as it is. Changes nothing.
    void refuseWhatCannotBeLeft() const;
    /// Reads all of it.
    void save();
    /// Sets what results depend on to what it is in a new context; where save() has found it so,
    /// nothing.
    void neutralise();
    /// The same without save(): everything, unasked.
    void neutraliseAll();
    /// Back to what save() found.
    void restore();

  private:
    struct Saved;
    Driver& driver_;
    std::unique_ptr<Saved> saved_;
};

}  // namespace sunder::gl
