// A stored answer of CalculiX is believed only as the answer to the very same input.
#include "physics/calculix_answers.hpp"

#include <cmath>
#include <fstream>
#include <limits>

#include "catch.hpp"
#include "physics/calculix.hpp"
#include "support/test_folder.hpp"

using Catch::Contains;
namespace fs = std::filesystem;

namespace {

const std::string kSmall = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n";
const CalculixAnswer kAnswer{"CalculiX 2.20", "\n displacements\n 1.5\n"};

}  // namespace

TEST_CASE("a stored answer comes back with its version, whatever the size of the input") {
    const TestFolder folder;
    const std::string large(200'000, '1');
    for (const std::string& input : {kSmall, large}) {
        storeAnswer(folder.path(), "bar", input, kAnswer);
        CHECK(fs::exists(folder.path() / "bar.inp") == (input == kSmall));
        CHECK(storedProgram(folder.path(), "bar") == kAnswer.program);
        const CalculixAnswer answer = storedAnswer(folder.path(), "bar", input);
        CHECK(answer.program == kAnswer.program);
        CHECK(answer.printed == kAnswer.printed);
        CHECK_THROWS_WITH(storedAnswer(folder.path(), "bar", input + "*STEP\n"),
                          Contains("another input") && Contains("tools/update-calculix bar"));
    }
}

TEST_CASE("a stored answer to another input is refused with the line that differs") {
    const TestFolder folder;
    storeAnswer(folder.path(), "bar", kSmall, kAnswer);
    CHECK_THROWS_WITH(storedAnswer(folder.path(), "bar", "*NODE\n1, 0, 0, 0\n2, 1, 0, 0.5\n"),
                      Contains("Line 3 was '2, 1, 0, 0' and is '2, 1, 0, 0.5'."));
    CHECK_THROWS_WITH(storedAnswer(folder.path(), "bar", "*NODE\n1, 0, 0, 0\n"),
                      Contains("Line 3 was '2, 1, 0, 0' and is ''."));
    // Only the input that is kept for readers was changed, or is gone.
    std::ofstream(folder.path() / "bar.inp", std::ios::app) << "3, 0, 0, 0\n";
    CHECK_THROWS_WITH(storedAnswer(folder.path(), "bar", kSmall), Contains("another input"));
    fs::remove(folder.path() / "bar.inp");
    CHECK_THROWS_WITH(storedAnswer(folder.path(), "bar", kSmall), Contains("another input"));
}

TEST_CASE("an answer that is not stored is refused with the command that makes it") {
    const TestFolder folder;
    for (const bool damaged : {false, true}) {
        if (damaged) std::ofstream(folder.path() / "bar.dat") << "half a lin";
        CHECK_THROWS_WITH(
            storedAnswer(folder.path(), "bar", kSmall),
            Contains("No answer of CalculiX") && Contains("tools/update-calculix bar"));
    }
}

TEST_CASE("answers differ by a share of the largest number") {
    CHECK(answerDifference({1, -4}, {1, -4}) == 0);
    CHECK(answerDifference({1, -4}, {1.5, -4.25}) == Approx(0.125));
    CHECK(std::isinf(answerDifference({1, -4}, {1})));
    CHECK_FALSE(answerDifference({1, -4}, {std::nan(""), -4}) <= 1);
    CHECK_FALSE(answerDifference({1, -4}, {std::nan(""), -4.25}) <= 1);
}
