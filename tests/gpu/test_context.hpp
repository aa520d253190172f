#pragma once
#include "window/context.hpp"

/// The context of the running test case, made when first asked for. A test that cannot have one
/// fails, with the reason.
sunder::window::Context& testContext();

/// In a Command, where no test case ends: the context goes with this, before the driver does.
struct TestContextOfCommand {
    TestContextOfCommand() = default;
    ~TestContextOfCommand();
    TestContextOfCommand(const TestContextOfCommand&) = delete;
    TestContextOfCommand& operator=(const TestContextOfCommand&) = delete;
};
