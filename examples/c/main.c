/* A wooden wall on the CPU, shoved until it breaks: C99. */
#include <sunder/sunder.h>

#include <stdio.h>

static int fail(const char* what) {
    fprintf(stderr, "%s: %s\n", what, sunder_message());
    return 1;
}

int main(void) {
    sunder_desc* desc = sunder_desc_create();
    sunder_body wall = sunder_body_default();
    sunder_push shove = sunder_push_default();
    const sunder_incident* incidents;
    sunder_world* world;
    int frame, broken = 0, pieces = 0;
    size_t count = 0;

    if (!desc || sunder_desc_add_material(desc, "wood", &wall.material) != SUNDER_OK)
        return fail("material");
    wall.size[0] = 2, wall.size[1] = 2.4, wall.size[2] = 0.1;
    wall.cells[0] = 16, wall.cells[1] = 20, wall.cells[2] = 1;
    wall.anchors = SUNDER_BOTTOM | SUNDER_TOP;
    if (sunder_desc_add_body(desc, &wall, NULL) != SUNDER_OK) return fail("body");

    world = sunder_world_create(desc, NULL, NULL);
    sunder_desc_destroy(desc);
    if (!world) return fail("world");

    shove.at[1] = 1.2;
    shove.radius = 0.35;
    shove.velocity[2] = -40;
    if (sunder_world_push(world, &shove) != SUNDER_OK) return fail("push");
    for (frame = 0; frame < 60; ++frame) {
        if (sunder_world_step(world, 1.0 / 60) != SUNDER_OK) return fail("step");
        count += sunder_world_incidents(world, &incidents);
    }
    if (sunder_world_broken_bonds(world, &broken) != SUNDER_OK ||
        sunder_world_pieces(world, &pieces) != SUNDER_OK)
        return fail("state");
    printf("after %.1f s: %d bonds broken, %d pieces, %u incidents\n", sunder_world_time(world),
           broken, pieces, (unsigned)count);
    sunder_world_destroy(world);
    return broken > 0 ? 0 : 1;
}
