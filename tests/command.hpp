#pragma once
#include <string>
#include <vector>

/// What a test program does instead of testing where its first argument is `option`, such as
/// --update-states. It is no test case: a choice of test cases by what they are not, such as
/// `sunder_unit_tests '~[solvers]'`, would run hidden ones too. What it throws is printed, and the
/// program ends with 1.
struct Command {
    using Run = void (*)(const std::vector<std::string>& arguments);

    Command(const std::string& option, Run run);
};
