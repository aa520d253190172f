#include "gpu/incident_pass.hpp"

#include <algorithm>
#include <bit>

#include "gpu/layout.hpp"

#include "core/constants.hpp"

namespace sunder::gpu {

using namespace core;

namespace {

/// A look finds at most so many incidents, or the ring's capacity, whichever is more.
constexpr std::size_t kLeastRoom = 4096;

GLuint resultOf(const gl::Query& query) {
    GLuint result = 0;
    glGetQueryObjectuiv(query.id(), GL_QUERY_RESULT, &result);
    return result;
}

}  // namespace

IncidentPass::IncidentPass(const World& world, ContactPass::Storage storage, int columns,
                           const ContactPass* contact, const ObjectPass* objects,
                           IncidentRing& ring)
    : world_(world),
      contact_(contact),
      objects_(objects),
      ring_(ring),
      interval_(stepsPerLook(world)),
      room_(std::max(kLeastRoom, ring.capacity())) {
    const bool buffers = storage == ContactPass::Storage::Buffers;
    knownTexels_ = buffers ? kBondTexels : 1;
    const std::size_t texels =
        buffers ? std::size_t{kBondTexels} * world.cellCount()
                : std::size_t(columns) * texelRows(world.cellCount(), columns, "known bonds");
    known_ = gl::Buffer(texels * sizeof(vec4), nullptr, GL_DYNAMIC_COPY, "known bonds");
    knownTexture_ = gl::makeBufferTexture(known_, GL_RGBA32F, "known bonds");
    for (Answer& answer : answers_) {
        answer.records =
            gl::Buffer(room_ * sizeof(Record), nullptr, GL_STREAM_READ, "incidents found");
        answer.written = gl::makeQuery();
        answer.found = gl::makeQuery();
    }
    gl::Defines defines = {{"SPHERE_BITS", "0"}, {"BUFFERS", buffers ? "1" : "0"}};
    if (contact) {
        defines = contact->defines();
        for (int i = 0; i < 3; ++i) pushes_.push_back(contact->sphereTarget("pushes"));
        cellProgram_ =
            contact->program(pushes_[0], "contact/push.frag", gl::with(defines, "IMPULSES", "1"));
    }
    if (objects) objectProgram_ = objects->impulseProgram(pushes_[0]);
    lookProgram_ = gl::Program({.vertex = "incidents/look.vert",
                                .geometry = "incidents/look.geom",
                                .defines = gl::with(defines, "CONTACT", contact ? "1" : "0"),
                                .feedback = {"placeImpulse", "what"}});
    setConstants(lookProgram_, world, columns);
    glUniform1f(lookProgram_.uniform("blowSpeed"), static_cast<float>(kBlowSpeed));
    forget();
}

void IncidentPass::clear(const TexelTarget& pushes) const {
    constexpr GLfloat zero[] = {0, 0, 0, 0};
    pushes.bind();
    glClearBufferfv(GL_COLOR, 0, zero);
}

void IncidentPass::forget() {
    for (const TexelTarget& pushes : pushes_) clear(pushes);
}

void IncidentPass::archive(Archive& a, const World& world, IncidentPass* pass) {
    a.section("incidents");
    if (!a.flag(pass != nullptr)) return;
    std::vector<std::uint8_t> broken(static_cast<std::size_t>(world.cellCount()));
    if (a.writes()) broken = pass->readKnown();
    for (std::uint8_t& bits : broken) bits = a.whole<std::uint8_t>(bits, 0, 7);
    if (a.reads() && pass) pass->writeKnown(broken);
    if (!world.description().contact) return;
    const int spheres = world.cellCount() << ContactPass::sphereBits(world);
    const auto known = [&](float rank) {
        const auto partner =
            static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(rank) & 0xffffffu);
        if (partner < world.cellCount()) return world.present(partner);
        const int object = kNobody - 1 - partner;
        return object >= 0 && object < static_cast<int>(world.objects().size());
    };
    for (int age = 0; age < 3; ++age) {
        std::vector<Push> pushes;
        if (a.writes()) pushes = pass->readPushes(age);
        a.list(pushes, static_cast<std::size_t>(spheres), [&](Push& push) {
            push.sphere = a.whole(push.sphere, 0, spheres - 1);
            push.impulse = a.real(push.impulse, 0.f);
            push.rank = a.real(push.rank, 0.f);
            a.require(a.writes() || push.impulse == 0 || known(push.rank));
        });
        if (a.reads() && pass) pass->writePushes(age, pushes);
    }
}

std::vector<IncidentPass::Push> IncidentPass::readPushes(int age) const {
    std::vector<Push> pushes;
    const int spheres = world_.cellCount() << ContactPass::sphereBits(world_);
    const std::vector<vec4> texels = pushes_[(current_ + age) % 3].read(0, {0, spheres});
    for (int sphere = 0; sphere < spheres; ++sphere)
        if (texels[sphere].x != 0) pushes.push_back({sphere, texels[sphere].x, texels[sphere].w});
    return pushes;
}

void IncidentPass::writePushes(int age, const std::vector<Push>& pushes) {
    const int spheres = world_.cellCount() << ContactPass::sphereBits(world_);
    std::vector<vec4> texels(static_cast<std::size_t>(spheres), vec4(0));
    for (const Push& push : pushes) texels[push.sphere] = {push.impulse, 0, 0, push.rank};
    pushes_[(current_ + age) % 3].write(0, 0, texels);
}

std::vector<std::uint8_t> IncidentPass::readKnown() const {
    std::vector<vec4> texels(known_.size() / sizeof(vec4));
    known_.read(0, known_.size(), texels.data());
    std::vector<std::uint8_t> broken(static_cast<std::size_t>(world_.cellCount()));
    for (std::size_t cell = 0; cell < broken.size(); ++cell)
        for (int axis = 0; axis < kBondsPerCell; ++axis)
            if (texels[knownTexels_ * cell][axis] >= 1)
                broken[cell] = static_cast<std::uint8_t>(broken[cell] | 1 << axis);
    return broken;
}

void IncidentPass::writeKnown(const std::vector<std::uint8_t>& broken) {
    std::vector<vec4> texels(known_.size() / sizeof(vec4), vec4(0));
    for (std::size_t cell = 0; cell < broken.size(); ++cell)
        for (int axis = 0; axis < kBondsPerCell; ++axis)
            texels[knownTexels_ * cell][axis] = static_cast<float>(broken[cell] >> axis & 1);
    known_.write(0, known_.size(), texels.data());
}

void IncidentPass::addPushes() {
    const TexelTarget& pushes = pushes_[current_];
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
    contact_->fillAwake(pushes, cellProgram_);
    if (objects_) {
        pushes.bind();
        objects_->drawPairs(objectProgram_);
    }
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
}

void IncidentPass::look(std::int64_t step) {
    Answer& answer = answers_[next_];
    next_ = (next_ + 1) % kLag;
    take(answer);
    gl::bindTexture(kKnownBonds, GL_TEXTURE_BUFFER, knownTexture_);
    constexpr int units[] = {kPushes, kPushesEarlier, kPushesBefore};
    for (int i = 0; i < static_cast<int>(pushes_.size()); ++i)
        gl::bindTexture(units[i], GL_TEXTURE_2D_ARRAY, pushes_[(current_ + i) % 3].texture());
    glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, answer.written.id());
    glBeginQuery(GL_PRIMITIVES_GENERATED, answer.found.id());
    feedback_.run(lookProgram_, {&answer.records}, world_.cellCount());
    glEndQuery(GL_PRIMITIVES_GENERATED);
    glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    answer.done = gl::Fence::insert();
    answer.step = step;
    if (pushes_.empty()) return;
    current_ = (current_ + 1) % 3;
    clear(pushes_[current_]);
}

void IncidentPass::finish() {
    for (int i = 0; i < kLag; ++i) take(answers_[(next_ + i) % kLag]);
}

void IncidentPass::take(Answer& answer) {
    if (answer.step < 0) return;
    answer.done.wait();
    std::vector<Record> records(resultOf(answer.written));
    answer.records.read(0, records.size() * sizeof(Record), records.data());
    for (const Record& record : records) ring_.push(incidentOf(record, answer.step));
    ring_.drop(std::int64_t{resultOf(answer.found)} - static_cast<std::int64_t>(records.size()));
    answer.step = -1;
}

Incident IncidentPass::incidentOf(const Record& record, std::int64_t step) const {
    Incident incident{.step = step, .impulse = record.impulse, .cell = record.cell};
    if (record.axis < kBondsPerCell)
        incident = breakOf(world_, kBondsPerCell * record.cell + record.axis, step);
    else if (const int object = kNobody - 1 - record.partner;
             object < static_cast<int>(world_.objects().size()))
        incident.object = object;
    else
        incident.other = record.partner;
    incident.place = {record.place[0], record.place[1], record.place[2]};
    return incident;
}

}  // namespace sunder::gpu
