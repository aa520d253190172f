// What ContactPass keeps between two steps, as bytes.
#include <algorithm>
#include <cmath>

#include "core/archive.hpp"
#include "gpu/contact_pass.hpp"
#include "gpu/feedback.hpp"

namespace sunder::gpu {

using namespace core;

void ContactPass::archive(Archive& a) {
    a.section("contacts");
    const bool due = a.flag(due_);
    GLuint exposed = 0;
    if (a.writes() && !due) glGetQueryObjectuiv(anyExposed_.id(), GL_QUERY_RESULT, &exposed);
    const bool anyExposed = a.flag(exposed != 0);
    const auto spheres = static_cast<std::size_t>(sphereCount());
    std::vector<Found> found;
    std::vector<Place> still;
    if (a.writes()) {
        found = readFound();
        still = readStill(found);
    }
    a.list(found, spheres, [&](Found& some) { archive(a, some); });
    a.list(still, spheres, [&](Place& place) {
        place.sphere = archiveSphere(a, place.sphere);
        for (vec4* v : {&place.centre, &place.velocity})
            for (int i = 0; i < 4; ++i) (*v)[i] = a.real((*v)[i]);
    });
    archiveHaste(a);
    if (!a.reads()) return;
    writeFound(found);
    writePlaces(still, anyExposed);
    due_ = due;
}

int ContactPass::archiveSphere(Archive& a, int now) const {
    const int sphere = a.whole(now, 0, sphereCount() - 1);
    a.require(world_.present(sphere >> sphereBits_));
    return sphere;
}

void ContactPass::archive(Archive& a, Found& found) const {
    found.sphere = archiveSphere(a, found.sphere);
    found.close = a.real(found.close, 0.f, 1e6f);
    found.leftOut = a.real(found.leftOut, 0.f, 256.f * kHasteUnit);
    found.touched = a.real(found.touched, 0.f, static_cast<float>(world_.bodies().size() + 1));
    const auto count =
        a.whole<std::uint8_t>(static_cast<std::uint8_t>(found.partners.size()), 0, kMostPartners);
    found.partners.resize(count);
    for (float& partner : found.partners) {  // counted from 1; negative: a lattice neighbour
        const bool neighbour = a.flag(partner < 0);
        const auto number = static_cast<int>(std::abs(partner)) - 1;
        const auto got = static_cast<float>(archiveSphere(a, number) + 1);
        partner = neighbour ? -got : got;
    }
}

std::vector<ContactPass::Found> ContactPass::readFound() const {
    const int spheres = sphereCount();
    std::array<std::vector<vec4>, kPartnerLayers> layers;
    for (int layer = 0; layer < kPartnerLayers; ++layer)
        layers[layer] = partners_.read(layer, {0, spheres});
    std::vector<Found> found;
    for (int sphere = 0; sphere < spheres; ++sphere) {
        const vec4& summary = layers[0][sphere];
        if (summary == vec4(0)) continue;
        found.push_back({sphere, summary.y, summary.z, summary.w, {}});
        Found& some = found.back();
        for (int i = 0; i < static_cast<int>(summary.x); ++i)
            some.partners.push_back(layers[1 + i / 4][sphere][i % 4]);
    }
    return found;
}

void ContactPass::writeFound(const std::vector<Found>& found) {
    const auto spheres = static_cast<std::size_t>(sphereCount());
    std::vector<vec4> texels(spheres);
    for (int layer = 0; layer < kPartnerLayers; ++layer) {
        std::fill(texels.begin(), texels.end(), vec4(0));
        for (const Found& some : found) {
            const int count = static_cast<int>(some.partners.size());
            vec4& texel = texels[some.sphere];
            if (layer == 0) {
                texel = {static_cast<float>(count), some.close, some.leftOut, some.touched};
                continue;
            }
            for (int i = 4 * (layer - 1); i < std::min(count, 4 * layer); ++i)
                texel[i % 4] = some.partners[i];
        }
        partners_.write(layer, 0, texels);
    }
    if (!summaries_) return;
    gl::bindTexture(kPartners, GL_TEXTURE_2D_ARRAY, partners_.texture());
    const TexelRange every{0, world_.cellCount()};
    TexelRanges cells(1, "all cells");
    cells.set({&every, 1}, columns_);
    summaries_->fill(summaryProgram_, cells);
}

/// Partners of others that have none themselves are not followed: they count as where they were.
std::vector<ContactPass::Place> ContactPass::readStill(const std::vector<Found>& found) const {
    std::vector<bool> wanted(static_cast<std::size_t>(sphereCount()), false);
    for (const Found& some : found)
        for (const float partner : some.partners)
            wanted[static_cast<std::size_t>(std::abs(partner)) - 1] = true;
    for (const Found& some : found)
        if (!some.partners.empty()) wanted[some.sphere] = false;
    std::vector<Place> still;
    if (std::find(wanted.begin(), wanted.end(), true) == wanted.end()) return still;
    const TexelRange every{0, sphereCount()};
    const std::vector<vec4> centres = spheres_.read(0, every), velocities = spheres_.read(1, every);
    for (int sphere = 0; sphere < every.end; ++sphere)
        if (wanted[sphere]) still.push_back({sphere, centres[sphere], velocities[sphere]});
    return still;
}

/// Those that follow are brought up to date before they count, sleepers are where they were, and
/// the query is to find what it had found.
void ContactPass::writePlaces(const std::vector<Place>& still, bool anyExposed) {
    glBeginQuery(GL_ANY_SAMPLES_PASSED, anyExposed_.id());
    if (anyExposed) spheres_.fill(sphereProgram_, heldSpheres_);
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    if (!anyExposed) spheres_.fill(sphereProgram_, heldSpheres_);
    for (const Place& place : still) {
        spheres_.write(0, place.sphere, {&place.centre, 1});
        spheres_.write(1, place.sphere, {&place.velocity, 1});
    }
}

void ContactPass::archiveHaste(Archive& a) {
    struct Hasty {
        int cell;
        float quarterOctaves;
    };
    std::vector<vec4> kept(static_cast<std::size_t>(world_.cellCount()), vec4(0));
    std::vector<Hasty> hasty;
    if (a.writes()) {
        kept = hastes_.read(0, {0, world_.cellCount()});
        for (int cell = 0; cell < world_.cellCount(); ++cell)
            if (kept[cell].x > 0) hasty.push_back({cell, kept[cell].x});
    }
    a.list(hasty, kept.size(), [&](Hasty& some) {
        some.cell = a.whole(some.cell, 0, world_.cellCount() - 1);
        some.quarterOctaves = a.real(some.quarterOctaves, 0.f, 255.f);
        kept[some.cell].x = some.quarterOctaves;
    });
    if (a.reads()) hastes_.write(0, 0, kept);
}

}  // namespace sunder::gpu
