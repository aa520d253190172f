#include "image/stored_state.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

#include "files/utf8_path.hpp"
#include "files/write_file.hpp"

using namespace sunder;
using namespace sunder::core;
namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little, "the files' order of bytes");

struct Header {
    char magic[8];
    std::uint32_t nodes, bonds, objects, unused;
    std::int64_t step;
    std::uint64_t checksum;  ///< of all that follows
};
constexpr char kMagic[8] = {'S', 'u', 'n', 'd', 'e', 'r', ' ', '1'};
constexpr std::size_t kVector = 3 * sizeof(float);
/// Whether it is there, position, orientation.
constexpr std::size_t kObject = 8 * sizeof(float);

/// FNV-1a, of 64 bits.
std::uint64_t checksum(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : bytes) hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001b3u;
    return hash;
}

class Writer {
  public:
    void add(double value) {
        const float single = static_cast<float>(value);
        const char* bytes = reinterpret_cast<const char*>(&single);
        bytes_.append(bytes, sizeof single);
    }
    void add(const Vec3& v) {
        for (const double x : v) add(x);
    }
    std::string& bytes() { return bytes_; }

  private:
    std::string bytes_;
};

class Reader {
  public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}
    double number() {
        float single = 0;
        std::memcpy(&single, take(sizeof single).data(), sizeof single);
        return single;
    }
    Vec3 vector() {
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }
    std::string_view take(std::size_t size) {
        const std::string_view taken = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
        return taken;
    }

  private:
    std::string_view bytes_;
};

std::size_t bitBytes(std::size_t bonds) {
    return (bonds + 7) / 8;
}

}  // namespace

std::string encodeState(const State& state) {
    Writer body;
    for (const Vec3& displacement : state.displacement) body.add(displacement);
    for (const ObjectState& object : state.objects) {
        body.add(object.present ? 1. : 0.);
        body.add(object.position);
        for (const double x : object.orientation.coeffs()) body.add(x);
    }
    std::string broken(bitBytes(state.damage.size()), '\0');
    for (std::size_t bond = 0; bond < state.damage.size(); ++bond)
        if (state.damage[bond] >= 1 && state.damage[bond] < kNoBond)
            broken[bond / 8] = static_cast<char>(broken[bond / 8] | 1 << bond % 8);
    body.bytes() += broken;

    Header header{};
    std::memcpy(header.magic, kMagic, sizeof kMagic);
    header.nodes = static_cast<std::uint32_t>(state.displacement.size());
    header.bonds = static_cast<std::uint32_t>(state.damage.size());
    header.objects = static_cast<std::uint32_t>(state.objects.size());
    header.step = state.step;
    header.checksum = checksum(body.bytes());
    return std::string(reinterpret_cast<const char*>(&header), sizeof header) + body.bytes();
}

State decodeState(std::string_view bytes, const World& world, const std::string& name) {
    Header header;
    if (bytes.size() < sizeof header || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0)
        throw StateError(name + ": not a stored state");
    std::memcpy(&header, bytes.data(), sizeof header);
    bytes.remove_prefix(sizeof header);
    if (bytes.size() !=
            header.nodes * kVector + header.objects * kObject + bitBytes(header.bonds) ||
        checksum(bytes) != header.checksum)
        throw StateError(name + ": a damaged stored state");
    State state = world.initialState();
    if (header.nodes != state.displacement.size() || header.bonds != state.damage.size() ||
        header.objects != state.objects.size())
        throw StateError(name + ": a state of another world, with " + std::to_string(header.nodes) +
                         " nodes and " + std::to_string(header.objects) + " objects instead of " +
                         std::to_string(state.displacement.size()) + " and " +
                         std::to_string(state.objects.size()));
    state.step = header.step;
    Reader body(bytes);
    for (Vec3& displacement : state.displacement) displacement = body.vector();
    for (ObjectState& object : state.objects) {
        object.present = body.number() != 0;
        object.position = body.vector();
        for (double& x : object.orientation.coeffs()) x = body.number();
    }
    const std::string_view broken = body.take(bitBytes(state.damage.size()));
    // A bond that a changed scene no longer has stays absent.
    for (std::size_t bond = 0; bond < state.damage.size(); ++bond)
        if ((broken[bond / 8] >> bond % 8 & 1) && state.damage[bond] < kNoBond)
            state.damage[bond] = 1;
    return state;
}

void writeState(const fs::path& path, const State& state) {
    fs::create_directories(path.parent_path());
    files::writeFile(path, encodeState(state));
}

State readState(const fs::path& path, const World& world) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw StateError(files::utf8FromPath(path) + ": there is no stored state");
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    return decodeState(bytes, world, files::utf8FromPath(path));
}
