#include "gpu/object_count.hpp"

using namespace sunder;

namespace {

int objectsAlive = 0;
gl::Functions original;

template <auto Make>
void GLAD_API_PTR makeSeveral(GLsizei number, GLuint* names) {
    objectsAlive += number;
    (original.*Make)(number, names);
}
template <auto Delete>
void GLAD_API_PTR deleteSeveral(GLsizei number, const GLuint* names) {
    for (GLsizei i = 0; i < number; ++i) objectsAlive -= names[i] != 0;
    (original.*Delete)(number, names);
}
template <auto Delete>
void GLAD_API_PTR deleteOne(GLuint name) {
    objectsAlive -= name != 0;
    (original.*Delete)(name);
}
GLuint GLAD_API_PTR makeProgram() {
    ++objectsAlive;
    return original.CreateProgram();
}
GLuint GLAD_API_PTR makeShader(GLenum stage) {
    ++objectsAlive;
    return original.CreateShader(stage);
}
GLsync GLAD_API_PTR makeSync(GLenum condition, GLbitfield flags) {
    ++objectsAlive;
    return original.FenceSync(condition, flags);
}
void GLAD_API_PTR deleteSync(GLsync sync) {
    objectsAlive -= sync != nullptr;
    original.DeleteSync(sync);
}

using F = gl::Functions;

template <auto Make, auto Delete>
void countKind(F& functions) {
    functions.*Make = makeSeveral<Make>;
    functions.*Delete = deleteSeveral<Delete>;
}

}  // namespace

ObjectCount::ObjectCount(gl::Functions& functions) : functions_(functions), before_(functions) {
    objectsAlive = 0;
    original = functions;
    countKind<&F::GenBuffers, &F::DeleteBuffers>(functions);
    countKind<&F::GenTextures, &F::DeleteTextures>(functions);
    countKind<&F::GenFramebuffers, &F::DeleteFramebuffers>(functions);
    countKind<&F::GenRenderbuffers, &F::DeleteRenderbuffers>(functions);
    countKind<&F::GenVertexArrays, &F::DeleteVertexArrays>(functions);
    countKind<&F::GenTransformFeedbacks, &F::DeleteTransformFeedbacks>(functions);
    countKind<&F::GenSamplers, &F::DeleteSamplers>(functions);
    countKind<&F::GenQueries, &F::DeleteQueries>(functions);
    countKind<&F::GenProgramPipelines, &F::DeleteProgramPipelines>(functions);
    functions.CreateProgram = makeProgram;
    functions.DeleteProgram = deleteOne<&F::DeleteProgram>;
    functions.CreateShader = makeShader;
    functions.DeleteShader = deleteOne<&F::DeleteShader>;
    functions.FenceSync = makeSync;
    functions.DeleteSync = deleteSync;
}

ObjectCount::~ObjectCount() {
    functions_ = before_;
}

int ObjectCount::alive() const {
    return objectsAlive;
}
