// A brick wall on the CPU, hit by a ball: prints what broke. No window, no GPU.
#include <sunder/sunder.hpp>

#include <cstdio>

int main() {
    sunder::WorldDesc desc;
    const int brick = desc.addMaterial(sunder::Material::preset("brick"));
    desc.addBody({.material = brick,
                  .size = {3, 2, 0.2},
                  .cells = {30, 20, 2},
                  .anchors = sunder::Side::Bottom});
    sunder::Object shot = sunder::Object::sphere(0.15);
    shot.mass = 60;
    const int ball = desc.addObject(shot);

    auto made = sunder::World::create(desc);
    if (!made) {
        std::fprintf(stderr, "headless: %s\n", made.error().message.c_str());
        return 1;
    }
    sunder::World& world = *made;
    for (const std::string& note : world.notes()) std::printf("note: %s\n", note.c_str());

    if (auto thrown =
            world.throwObject({.object = ball, .from = {0, 1.2, 2}, .velocity = {0, 0, -25}});
        !thrown) {
        std::fprintf(stderr, "headless: %s\n", thrown.error().message.c_str());
        return 1;
    }
    int breaks = 0, contacts = 0;
    for (int frame = 0; frame < 90; ++frame) {
        if (auto stepped = world.step(1.0 / 60); !stepped) {
            std::fprintf(stderr, "headless: %s\n", stepped.error().message.c_str());
            return 1;
        }
        for (const sunder::Incident& incident : world.incidents())
            ++(incident.kind == sunder::Incident::Kind::Break ? breaks : contacts);
    }

    const auto pieces = world.pieces();
    if (!pieces) return 1;
    double largest = 0, loose = 0;
    for (const sunder::Piece& piece : *pieces) {
        if (piece.mass > largest) largest = piece.mass;
        if (!piece.anchored) loose += piece.mass;
    }
    std::printf(
        "after %.1f s: %d bonds broke, %d hits, %zu pieces, the largest of %.0f kg, %.0f kg came "
        "loose\n",
        world.time(), breaks, contacts, pieces->size(), largest, loose);
    if (auto hit = world.castRay({-1.2, 0.3, 3}, {0, 0, -1}))
        std::printf("a ray meets body %d at z = %.3f m\n", hit->body, hit->place.z);
    return breaks > 0 ? 0 : 1;
}
