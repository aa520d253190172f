// stb's PNG reader, compiled here once.
#include <cstdlib>
#include <limits>

#include "image/stb_memory.hpp"

namespace sunder::image {
namespace {

thread_local std::size_t mostBytes = std::numeric_limits<std::size_t>::max();

void* allocate(std::size_t size) {
    return size <= mostBytes ? std::malloc(size) : nullptr;
}
void* reallocate(void* memory, std::size_t size) {
    return size <= mostBytes ? std::realloc(memory, size) : nullptr;
}

}  // namespace

StbMemoryLimit::StbMemoryLimit(std::size_t bytes) {
    mostBytes = bytes;
}
StbMemoryLimit::~StbMemoryLimit() {
    mostBytes = std::numeric_limits<std::size_t>::max();
}

}  // namespace sunder::image

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MALLOC(size) sunder::image::allocate(size)
#define STBI_REALLOC(memory, size) sunder::image::reallocate(memory, size)
#define STBI_FREE(memory) std::free(memory)
#include <stb_image.h>
