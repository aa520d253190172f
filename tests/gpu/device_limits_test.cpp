#include <cstdint>
#include <initializer_list>

#include "catch.hpp"
#include "core/world.hpp"
#include "gpu/test_context.hpp"
#include "gpu/texel_target.hpp"

using namespace sunder;
using namespace sunder::core;

TEST_CASE("a world larger than the device's textures is refused before anything is allocated") {
    const std::int64_t most = testContext().info().maxTextureSize;
    const int columns = gpu::texelColumns(most * most);
    REQUIRE(columns <= most);
    CHECK(gpu::texelRows(most * columns, columns, "nodes") == most);
    CHECK_THROWS_AS(gpu::texelRows(most * columns + 1, columns, "nodes"), InputError);
    CHECK_THROWS_WITH(gpu::texelRows(most * columns + 1, columns, "nodes"),
                      Catch::Contains("too large for this device") && Catch::Contains("nodes") &&
                          Catch::Contains(std::to_string(most)) && Catch::Contains("fewer cells"));
}

TEST_CASE("textures are wide enough for every cell a world may have, and hardly wider than high") {
    testContext();
    for (const std::int64_t count :
         std::initializer_list<std::int64_t>{1, 64, 3200, 32000, 1600000, 8 * kMaxCells}) {
        const std::int64_t columns = gpu::texelColumns(count),
                           rows = gpu::texelRows(count, int(columns), "nodes");
        CHECK(columns * rows >= count);
        CHECK(rows <= 4 * columns);
        CHECK((columns == 64 || columns <= 2 * rows));
    }
}
