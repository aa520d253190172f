#include "gpu/test_context.hpp"

#include <memory>

#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include "catch.hpp"

using namespace sunder;

namespace {

std::unique_ptr<window::Context>& shared() {
    static std::unique_ptr<window::Context> context;
    return context;
}

#if __has_include(<catch2/catch_all.hpp>)
using Listener = Catch::EventListenerBase;
#else
using Listener = Catch::TestEventListenerBase;
#endif

/// Contexts live one at a time, and some test cases make their own: the shared one goes after each
/// test case, so that the order of test cases does not matter.
struct ReleaseContext : Listener {
    using Listener::Listener;
    void testCaseEnded(const Catch::TestCaseStats&) override { shared().reset(); }
};
CATCH_REGISTER_LISTENER(ReleaseContext)

}  // namespace

window::Context& testContext() {
    if (!shared()) shared() = window::createHeadlessContext();
    return *shared();
}

TestContextOfCommand::~TestContextOfCommand() {
    shared().reset();
}
