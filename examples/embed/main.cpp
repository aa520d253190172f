// A wall in somebody else's window, drawn with somebody else's shaders: Sunder as a guest in a
// program's own OpenGL context. A click hits the wall where the mouse is. `embed 120 picture.ppm`
// hits it by itself, runs so many frames and leaves a picture.
#define GL_GLEXT_PROTOTYPES
#define GLFW_INCLUDE_GLCOREARB
#include <GLFW/glfw3.h>

#include <sunder/gl.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

// Everything is seen from here, to the lower left; `kAxes` are the camera's right, up and back.
constexpr sunder::Vec3 kEye{2.2, 1.9, 3.1};
constexpr sunder::Vec3 kAxes[] = {
    {0.816, 0, -0.578}, {-0.139, 0.971, -0.196}, {0.561, 0.240, 0.792}};
constexpr double kZoom = 1.9;

const char* const kVertexShader = R"(#version 410 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 7) in int cell;
uniform vec3 eye;
uniform mat3 axes;
uniform vec2 zoom;
out vec3 n;
flat out float tint;
void main() {
    n = normal;
    tint = 0.8 + 0.4 * fract(0.618034 * float(cell));
    vec3 p = (position - eye) * axes;
    gl_Position = vec4(zoom * p.xy, -p.z - 0.2, -p.z);
})";
const char* const kFragmentShader = R"(#version 410 core
in vec3 n;
flat in float tint;
uniform vec3 colour;
out vec4 pixel;
void main() {
    float light = 0.35 + 0.65 * max(0.0, dot(normalize(n), normalize(vec3(0.4, 0.7, 0.6))));
    pixel = vec4(sqrt(tint * colour * light), 1.0);
})";

float f(double value) {
    return static_cast<float>(value);
}

GLuint shader(GLenum type, const char* text) {
    const GLuint made = glCreateShader(type);
    glShaderSource(made, 1, &text, nullptr);
    glCompileShader(made);
    return made;
}

int fail(const std::string& message) {
    std::fprintf(stderr, "embed: %s\n", message.c_str());
    return 1;
}

void writePicture(const char* path, int width, int height) {
    std::vector<unsigned char> pixels(3u * width * height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    if (std::FILE* file = std::fopen(path, "wb")) {
        std::fprintf(file, "P6 %d %d 255\n", width, height);
        for (int row = height; row-- > 0;) std::fwrite(&pixels[3u * width * row], 3, width, file);
        std::fclose(file);
    }
}

}  // namespace

int main(int count, char** arguments) {
    const int frames = count > 1 ? std::atoi(arguments[1]) : 0;
    if (!glfwInit()) return fail("there is no display");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    GLFWwindow* window = glfwCreateWindow(960, 540, "embed", nullptr, nullptr);
    if (!window) return fail("there is no OpenGL 4.1");
    glfwMakeContextCurrent(window);

    const GLuint program = glCreateProgram();
    glAttachShader(program, shader(GL_VERTEX_SHADER, kVertexShader));
    glAttachShader(program, shader(GL_FRAGMENT_SHADER, kFragmentShader));
    glLinkProgram(program);

    sunder::WorldDesc desc;
    const int brick = desc.addMaterial(sunder::Material::preset("brick"));
    desc.addBody({.material = brick,
                  .size = {3, 2, 0.2},
                  .cells = {30, 20, 2},
                  .anchors = sunder::Side::Bottom});
    {
        sunder::gl::Device device({.getProcAddress = glfwGetProcAddress});
        auto made = sunder::World::create(desc, {.device = &device});
        if (!made) return fail(made.error().message);
        sunder::World& world = *made;
        sunder::gl::Surface surface(device, world);
        if (!surface.ok()) return fail(surface.error().message);

        bool wasDown = false;
        for (int frame = 0; !glfwWindowShouldClose(window) && (frames == 0 || frame < frames);
             ++frame) {
            int width, height;
            glfwGetFramebufferSize(window, &width, &height);
            const double aspect = static_cast<double>(width) / (height > 0 ? height : 1);
            const bool down = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
            if ((down && !wasDown) || (frames > 0 && frame == 10)) {
                double x = 0.5 * width, y = 0.45 * height;
                int windowWidth, windowHeight;
                glfwGetWindowSize(window, &windowWidth, &windowHeight);
                if (down) {
                    glfwGetCursorPos(window, &x, &y);
                    x *= static_cast<double>(width) / windowWidth,
                        y *= static_cast<double>(height) / windowHeight;
                }
                // The projection of the vertex shader, the other way round.
                const double right = (2 * x / width - 1) * aspect / kZoom,
                             up = (1 - 2 * y / height) / kZoom;
                const sunder::Vec3 ray{right * kAxes[0].x + up * kAxes[1].x - kAxes[2].x,
                                       right * kAxes[0].y + up * kAxes[1].y - kAxes[2].y,
                                       right * kAxes[0].z + up * kAxes[1].z - kAxes[2].z};
                if (auto aim = world.castRay(kEye, ray))
                    world.push({.at = aim->place,
                                .radius = 0.45,
                                .velocity = {0, 0, -25},
                                .falloff = true});
            }
            wasDown = down;
            world.step(1.0 / 60);
            surface.update();

            glViewport(0, 0, width, height);
            glClearColor(0.75f, 0.82f, 0.9f, 1);
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            glEnable(GL_DEPTH_TEST);
            glEnable(GL_CULL_FACE);
            glUseProgram(program);
            const float axes[] = {f(kAxes[0].x), f(kAxes[0].y), f(kAxes[0].z),
                                  f(kAxes[1].x), f(kAxes[1].y), f(kAxes[1].z),
                                  f(kAxes[2].x), f(kAxes[2].y), f(kAxes[2].z)};
            glUniform3f(glGetUniformLocation(program, "eye"), f(kEye.x), f(kEye.y), f(kEye.z));
            glUniformMatrix3fv(glGetUniformLocation(program, "axes"), 1, GL_FALSE, axes);
            glUniform2f(glGetUniformLocation(program, "zoom"), f(kZoom / aspect), f(kZoom));
            glBindVertexArray(surface.vertexArray());
            for (const sunder::gl::Range& range : surface.ranges()) {
                const sunder::Material& look = desc.materials[range.material];
                const sunder::Vec3 c = range.inside ? look.insideColour : look.colour;
                glUniform3f(glGetUniformLocation(program, "colour"), f(c.x), f(c.y), f(c.z));
                glDrawElements(GL_TRIANGLES, range.count, GL_UNSIGNED_INT, range.offset);
            }
            if (count > 2 && frame == frames - 1) writePicture(arguments[2], width, height);
            glfwSwapBuffers(window);
            glfwPollEvents();
        }
        const auto broken = world.brokenBonds();
        std::printf("%d bonds broke on %s\n", broken ? *broken : -1,
                    std::string(device.renderer()).c_str());
        if (frames > 10 && (!broken || *broken == 0)) return fail("nothing broke");
    }
    glfwTerminate();
}
