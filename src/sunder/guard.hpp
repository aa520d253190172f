#pragma once
#include <exception>
#include <new>

#include "core/types.hpp"
#include "sunder/types.hpp"

namespace sunder {

/// What was thrown, as the public interface says it. Called in a catch clause.
inline Error currentError() {
    try {
        throw;
    } catch (const core::MemoryError& error) {
        return {Error::Code::Memory, error.what()};
    } catch (const core::InputError& error) {
        return {Error::Code::Input, error.what()};
    } catch (const core::DeviceError& error) {
        return {Error::Code::Device, error.what()};
    } catch (const std::bad_alloc&) {
        return {Error::Code::Memory, "there is not enough memory"};
    } catch (const std::exception& error) {
        return {Error::Code::Bug, error.what()};
    } catch (...) {
        return {Error::Code::Bug, "something was thrown that is no error"};
    }
}

/// What `work` returns, a Result, or what it throws.
template <class Work>
auto guarded(const Work& work) -> decltype(work()) {
    try {
        return work();
    } catch (...) {
        return currentError();
    }
}

}  // namespace sunder
