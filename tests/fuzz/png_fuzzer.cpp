// Pictures given to `sunder compare`: refused in a sentence, or compared.
#include "fuzz/fuzzer.hpp"
#include "image/comparison.hpp"
#include "image/image.hpp"

using namespace sunder;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const Image image = decodePng(fuzz::text(data, size), "fuzz.png");
        if (image.pixels.size() > 100'000) return 0;  // so that an input takes milliseconds
        Image other = image;
        other.pixels.front() ^= 255;
        differencePicture(image, other, compare(image, other, 8));
    } catch (const InputError& error) {
        fuzz::checkSentence(error);
    }
    return 0;
}
