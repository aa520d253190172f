#include "window/context.hpp"

#include <utility>

namespace sunder::window {

Context::~Context() = default;

void Context::initialise(std::string device) {
    driver_.emplace(loadFunction(), std::move(device), gl::Driver::Owner::Sunder);
    driver_->makeCurrent();
    info_ = driver_->info();
}

void Context::makeCurrent() {
    bindContext();
    driver_->makeCurrent();
}

}  // namespace sunder::window
