#include <cstring>
#include <new>
#include <string>

#include "core/rules.hpp"
#include "sunder/c_handles.hpp"
#include "sunder/convert.hpp"
#include "sunder/guard.hpp"

using namespace sunder;

namespace {

thread_local std::string lastMessage;

Vec3 vec3(const double* v) {
    return v ? Vec3{v[0], v[1], v[2]} : Vec3{};
}
Quat quat(const double* q) {
    return q ? Quat{q[0], q[1], q[2], q[3]} : Quat{};
}
void put(const Vec3& from, double* to) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

/// An enumeration's number. C can put any into it, which C++ must not read as the enumeration.
template <class Enumeration>
int numberIn(const Enumeration& enumeration) {
    int number = 0;
    static_assert(sizeof number == sizeof enumeration);
    std::memcpy(&number, &enumeration, sizeof number);
    return number;
}

/// `work` returns a Result; null pointers among `needed` are refused.
template <class Work>
sunder_status run(std::initializer_list<const void*> needed, const Work& work) noexcept {
    for (const void* pointer : needed)
        if (!pointer) return fail({Error::Code::Input, "a pointer that is needed is null"});
    return statusOf(guarded(work));
}

sunder_desc* descOf(const Result<WorldDesc>& made) {
    if (!made) {
        fail(made.error());
        return nullptr;
    }
    return new (std::nothrow) sunder_desc{*made};
}

}  // namespace

namespace sunder {

sunder_status fail(const Error& error) noexcept {
    try {
        lastMessage = error.message;
    } catch (...) {
        lastMessage.clear();
    }
    return static_cast<sunder_status>(error.code);
}

}  // namespace sunder

void sunder_version(int* major, int* minor, int* patch) {
    const Version v = version();
    if (major) *major = v.major;
    if (minor) *minor = v.minor;
    if (patch) *patch = v.patch;
}

const char* sunder_message(void) {
    return lastMessage.c_str();
}

sunder_body sunder_body_default(void) {
    const BodyDesc d;
    sunder_body body{};
    body.material = d.material;
    put(d.size, body.size);
    for (int& cells : body.cells) cells = 1;
    body.orientation[0] = 1;
    body.present = d.present ? 1 : 0;
    return body;
}

sunder_object sunder_object_default(void) {
    const Object d;
    sunder_object object{};
    put(d.size, object.size);
    object.mass = d.mass;
    object.orientation[0] = 1;
    object.friction = d.friction;
    object.restitution = d.restitution;
    return object;
}

sunder_push sunder_push_default(void) {
    const Push d;
    sunder_push push{};
    push.body = d.body;
    push.radius = d.radius;
    push.duration = d.duration;
    return push;
}

sunder_desc* sunder_desc_create(void) {
    return new (std::nothrow) sunder_desc;
}

sunder_desc* sunder_desc_preset(const char* name) {
    return descOf(WorldDesc::preset(name ? name : ""));
}

sunder_desc* sunder_desc_load(const char* path) {
    return descOf(WorldDesc::load(path ? path : ""));
}

void sunder_desc_destroy(sunder_desc* desc) {
    delete desc;
}

sunder_status sunder_desc_add_material(sunder_desc* desc, const char* name_or_path, int* index) {
    return run({desc, name_or_path, index}, [&]() -> Result<void> {
        Result<Material> material = Material::load(name_or_path);
        if (!material) return material.error();
        *index = desc->desc.addMaterial(std::move(*material));
        return {};
    });
}

sunder_status sunder_desc_set_material(sunder_desc* desc, int material, const char* key,
                                       double value) {
    return run({desc, key}, [&]() -> Result<void> {
        if (material < 0 || material >= static_cast<int>(desc->desc.materials.size()))
            return Error{Error::Code::Input, "there is no material " + std::to_string(material)};
        const auto* rule = core::findRule(core::materialRules(), key);
        if (!rule || rule->count() != 1)
            return Error{Error::Code::Input, "a material has no number '" + std::string(key) + "'"};
        core::Material inside = toCore(desc->desc.materials[material]);
        rule->set(inside, {{value, 0, 0}, 1});
        desc->desc.materials[material] = fromCore(inside);
        return {};
    });
}

sunder_status sunder_desc_add_body(sunder_desc* desc, const sunder_body* body, int* index) {
    return run({desc, body}, [&]() -> Result<void> {
        BodyDesc d;
        d.material = body->material;
        d.size = vec3(body->size);
        d.cells = {body->cells[0], body->cells[1], body->cells[2]};
        d.position = vec3(body->position);
        d.orientation = quat(body->orientation);
        d.anchors = static_cast<Side>(body->anchors);
        d.present = body->present != 0;
        const int added = desc->desc.addBody(std::move(d));
        if (index) *index = added;
        return {};
    });
}

sunder_status sunder_desc_add_object(sunder_desc* desc, const sunder_object* object, int* index) {
    return run({desc, object}, [&]() -> Result<void> {
        Object d;
        d.shape = static_cast<Object::Shape>(numberIn(object->shape));
        d.size = vec3(object->size);
        d.mass = object->mass;
        const int motion = numberIn(object->motion);
        if (motion < SUNDER_FREE || motion > SUNDER_KINEMATIC)
            return Error{Error::Code::Input,
                         "an object's motion must be one of its enumeration's values, not " +
                             std::to_string(motion)};
        d.isFixed = motion == SUNDER_FIXED;
        d.isKinematic = motion == SUNDER_KINEMATIC;
        if (object->present) d.position = vec3(object->position);
        d.orientation = quat(object->orientation);
        d.velocity = vec3(object->velocity);
        d.friction = object->friction;
        d.restitution = object->restitution;
        const int added = desc->desc.addObject(std::move(d));
        if (index) *index = added;
        return {};
    });
}

void sunder_desc_set_gravity(sunder_desc* desc, double x, double y, double z) {
    desc->desc.gravity = {x, y, z};
}

void sunder_desc_set_ground(sunder_desc* desc, int ground) {
    desc->desc.ground = ground != 0;
}

void sunder_desc_set_contact(sunder_desc* desc, int contact) {
    desc->desc.contact = contact != 0;
}

void sunder_desc_set_substep(sunder_desc* desc, double seconds) {
    desc->desc.substep = seconds;
}

void sunder_desc_set_seed(sunder_desc* desc, uint64_t seed) {
    desc->desc.seed = seed;
}

sunder_world* sunder_world_create(const sunder_desc* desc, sunder_device* device,
                                  const char* solver) {
    try {
        if (!desc) throw core::InputError("the description is null");
        WorldOptions options;
        options.device = device ? &device->device() : nullptr;
        if (solver) options.solver = solver;
        Result<World> made = World::create(desc->desc, options);
        if (made) return new sunder_world{std::move(*made), {}, {}};
        fail(made.error());
    } catch (...) {
        fail(currentError());
    }
    return nullptr;
}

void sunder_world_destroy(sunder_world* world) {
    delete world;
}

sunder_status sunder_world_step(sunder_world* world, double seconds) {
    return run({world}, [&] { return world->world.step(seconds); });
}

sunder_status sunder_world_finish(sunder_world* world) {
    return run({world}, [&] { return world->world.finish(); });
}

double sunder_world_time(const sunder_world* world) {
    return world->world.time();
}

double sunder_world_look_time(const sunder_world* world) {
    return world->world.lookTime();
}

sunder_status sunder_world_push(sunder_world* world, const sunder_push* push) {
    return run({world, push}, [&] {
        return world->world.push({push->body, vec3(push->at), push->radius, vec3(push->velocity),
                                  vec3(push->impulse), vec3(push->force), push->outward,
                                  push->falloff != 0, push->duration, push->delay});
    });
}

sunder_status sunder_world_throw(sunder_world* world, int object, const double* from,
                                 const double* velocity, const double* spin) {
    return run({world, from, velocity}, [&] {
        return world->world.throwObject({0, object, vec3(from), vec3(velocity), vec3(spin)});
    });
}

sunder_status sunder_world_set_kinematic(sunder_world* world, int object, const double* position,
                                         const double* orientation, const double* velocity,
                                         const double* spin) {
    return run({world, position}, [&] {
        return world->world.setKinematic(object, {vec3(position), quat(orientation)},
                                         vec3(velocity), vec3(spin));
    });
}

sunder_status sunder_world_remove_object(sunder_world* world, int object) {
    return run({world}, [&] { return world->world.removeObject(object); });
}

sunder_status sunder_world_add_body(sunder_world* world, int body) {
    return run({world}, [&] { return world->world.addBody(body); });
}

sunder_status sunder_world_remove_body(sunder_world* world, int body) {
    return run({world}, [&] { return world->world.removeBody(body); });
}

sunder_status sunder_world_release_anchors(sunder_world* world, int body) {
    return run({world}, [&] { return world->world.releaseAnchors(body); });
}

sunder_status sunder_world_extend(sunder_world* world, const sunder_desc* desc) {
    return run({world, desc}, [&] { return world->world.extend(desc->desc); });
}

sunder_status sunder_world_save(sunder_world* world, const void** bytes, size_t* size) {
    return run({world, bytes, size}, [&]() -> Result<void> {
        Result<std::vector<std::byte>> saved = world->world.saveState();
        if (!saved) return saved.error();
        world->saved = std::move(*saved);
        *bytes = world->saved.data();
        *size = world->saved.size();
        return {};
    });
}

sunder_status sunder_world_restore(sunder_world* world, const void* bytes, size_t size) {
    return run({world, bytes}, [&] {
        return world->world.restoreState({static_cast<const std::byte*>(bytes), size});
    });
}

size_t sunder_world_incidents(sunder_world* world, const sunder_incident** incidents) {
    world->incidents.clear();
    const sunder_status status = run({world, incidents}, [&]() -> Result<void> {
        for (const Incident& i : world->world.incidents()) {
            sunder_incident& to = world->incidents.emplace_back();
            to = {i.kind == Incident::Kind::Break,
                  i.time,
                  {},
                  i.impulse,
                  i.body,
                  i.material,
                  i.otherBody,
                  i.otherMaterial,
                  i.object};
            put(i.place, to.place);
        }
        return {};
    });
    if (status != SUNDER_OK) return 0;
    *incidents = world->incidents.data();
    return world->incidents.size();
}

int sunder_world_cast_ray(const sunder_world* world, const double* origin, const double* direction,
                          sunder_ray_hit* hit) {
    const std::optional<RayHit> found = world->world.castRay(vec3(origin), vec3(direction));
    if (!found || !hit) return found ? 1 : 0;
    *hit = {found->distance, {}, {}, found->body, found->material, found->object, {}};
    put(found->place, hit->place);
    put(found->normal, hit->normal);
    put(found->restPlace, hit->rest_place);
    return 1;
}

sunder_status sunder_world_broken_bonds(const sunder_world* world, int* broken) {
    return run({world, broken}, [&]() -> Result<void> {
        const Result<int> found = world->world.brokenBonds();
        if (!found) return found.error();
        *broken = *found;
        return {};
    });
}

sunder_status sunder_world_pieces(const sunder_world* world, int* pieces) {
    return run({world, pieces}, [&]() -> Result<void> {
        const Result<std::vector<Piece>> found = world->world.pieces();
        if (!found) return found.error();
        *pieces = static_cast<int>(found->size());
        return {};
    });
}

sunder_status sunder_world_state_hash(const sunder_world* world, uint64_t* hash) {
    return run({world, hash}, [&]() -> Result<void> {
        const Result<std::uint64_t> found = world->world.stateHash();
        if (!found) return found.error();
        *hash = *found;
        return {};
    });
}
