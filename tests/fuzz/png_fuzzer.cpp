// Pictures given to `sunder compare`: refused in a sentence, or compared.
#include "fuzz/fuzzer.hpp"
#include "image/comparison.hpp"
#include "image/image.hpp"

using namespace sunder;
using namespace sunder::core;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const image::Image image = image::decodePng(fuzz::text(data, size), "fuzz.png");
        if (image.pixels.size() > 100'000) return 0;  // so that an input takes milliseconds
        image::Image other = image;
        other.pixels.front() ^= 255;
        image::differencePicture(image, other, image::compare(image, other, 8));
    } catch (const InputError& error) {
        fuzz::checkSentence(error);
    }
    return 0;
}
