#pragma once
#include <span>
#include <string>
#include <vector>

/// Runs the body of a GLSL main() once per item on the GPU, to test the functions under
/// glsl/physics by themselves.
struct VertexFunction {
    std::string includes;  ///< "physics/polar.glsl physics/eigen.glsl", separated by blanks
    std::string outputs;   ///< declarations: "out vec4 a; flat out uint b;"
    std::vector<std::string> names;  ///< of the outputs, in the order of the result
    std::string body;  ///< may read vec4 item(int i), the i-th of itemTexels vec4s, and gl_VertexID
    int itemTexels = 1;
    int resultFloats = 4;  ///< 32-bit words per item

    /// `input`: 4·itemTexels floats per item. Integers in the result come as bit patterns.
    std::vector<float> run(std::span<const float> input, int count) const;
};
