#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/solver.hpp"

/// A solver the tests in tests/solvers run on. Each test program defines solversUnderTest() for the
/// solvers it has.
struct SolverUnderTest {
    std::string name;
    /// `world` must outlive the solver.
    std::function<std::unique_ptr<sunder::core::Solver>(const sunder::core::World& world)> make;
    double epsilon;  ///< unit roundoff of its arithmetic; tolerances are stated in multiples of it
    bool sleeps = false;   ///< lets bodies at rest sleep
    bool contact = false;  ///< cells and objects push each other where the world says so
};

std::vector<SolverUnderTest> solversUnderTest();
/// Those that need no GL.
std::vector<SolverUnderTest> cpuSolvers();
/// Those that need a GL context; only in programs with gpu/gpu_solvers.cpp.
std::vector<SolverUnderTest> gpuSolvers();

/// What rounds for them: the GL driver, or "every system" where that makes no difference.
std::string driverUnderTest();

/// Those among them that have contact.
inline std::vector<SolverUnderTest> touchingSolvers() {
    std::vector<SolverUnderTest> result = solversUnderTest();
    std::erase_if(result, [](const SolverUnderTest& under) { return !under.contact; });
    return result;
}

/// Those that have the same bits in every run: `auto` gives bodies to whoever was faster.
inline std::vector<SolverUnderTest> exactSolvers() {
    std::vector<SolverUnderTest> result = solversUnderTest();
    std::erase_if(result, [](const SolverUnderTest& under) { return under.name == "auto"; });
    return result;
}

/// Those whose contact is their own, for what takes long: scatter and compute find and answer
/// contacts in gather's passes, and auto is cpu or gather. Short tests hold for all.
inline std::vector<SolverUnderTest> contactSolvers() {
    std::vector<SolverUnderTest> result = touchingSolvers();
    std::erase_if(result, [](const SolverUnderTest& under) {
        return under.name == "scatter" || under.name == "auto" || under.name == "compute";
    });
    return result;
}
