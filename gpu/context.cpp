// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/context.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <string_view>
#include <vector>

namespace trivar::gpu {
namespace {

// epoxy ends the program where it does not find the library.
bool has_egl()
{
    void* const library = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
    if (library) dlclose(library);
    return library != nullptr;
}

EGLDisplay surfaceless_display()
{
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        return EGL_NO_DISPLAY;
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
}

// Returns the displays of the device platform, or only those that are no software.
std::vector<EGLDisplay> device_displays(bool hardware_only)
{
    std::vector<EGLDisplay> out;
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) return out;
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (!eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count))
        return out;
    for (EGLint i = 0; i < count; ++i) {
        const EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
        const char* said = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
        const bool software =
            said && std::string_view(said).find("EGL_MESA_device_software") != std::string::npos;
        if (hardware_only && software) continue;
        out.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
    }
    return out;
}

EGLContext context_of(EGLDisplay display, int gl_version)
{
    // Without a surface the configuration matters little, but some drivers insist on one.
    const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                       EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count < 1) config = nullptr;
    const std::array<EGLint, 9> version{EGL_CONTEXT_MAJOR_VERSION,
                                        gl_version / 10,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        gl_version % 10,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_CONTEXT_OPENGL_DEBUG,
                                        EGL_TRUE,
                                        EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
}

} // namespace

struct HeadlessContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    // Makes a context current on the display; returns why not, or nothing.
    std::string open(EGLDisplay candidate)
    {
        if (candidate == EGL_NO_DISPLAY) return "not offered by this EGL";
        if (!eglInitialize(candidate, nullptr, nullptr)) return "cannot be initialised";
        display = candidate;
        std::string why;
        if (!eglBindAPI(EGL_OPENGL_API))
            why = "has no desktop OpenGL";
        else if ((context = context_of(display, 43)) == EGL_NO_CONTEXT &&
                 (context = context_of(display, least_gl_version)) == EGL_NO_CONTEXT)
            why = "has no OpenGL 3.3 core context";
        else if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
            why = "cannot draw without a surface";
        else
            why = lacking();
        if (!why.empty()) close();
        return why;
    }

    void close()
    {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        context = EGL_NO_CONTEXT;
        // The display is shared by everyone in the process who asked for it: it is not terminated.
        display = EGL_NO_DISPLAY;
    }
};

HeadlessContext::HeadlessContext(bool rather_hardware) : state_(std::make_unique<State>())
{
    if (!has_egl())
        throw Rejected("No OpenGL without a window here: there is no EGL (libEGL.so.1).");
    if (rather_hardware)
        for (const EGLDisplay display : device_displays(true)) {
            if (!state_->open(display).empty()) continue;
            if (!is_software()) return;
            state_->close();
        }
    const std::string surfaceless = state_->open(surfaceless_display());
    if (surfaceless.empty()) return;
    std::string device = state_->open(EGL_NO_DISPLAY); // unless there is one
    for (const EGLDisplay display : device_displays(false))
        if (device = state_->open(display); device.empty()) return;
    throw Rejected(fmt::format("No OpenGL without a window here: EGL's surfaceless platform {}, "
                               "its device platform {}; {}.",
                               surfaceless, device, better_opengl));
}

HeadlessContext::~HeadlessContext()
{
    state_->close();
}

std::string lacking()
{
    const int version = epoxy_gl_version();
    if (version >= 43) return {};
    std::string missing;
    for (const char* name : {"GL_ARB_texture_storage", "GL_ARB_texture_view", "GL_ARB_copy_image",
                             "GL_ARB_shading_language_420pack", "GL_ARB_shading_language_packing"})
        if (!epoxy_has_gl_extension(name))
            missing += std::string(missing.empty() ? "" : ", ") + name;
    if (version >= least_gl_version && missing.empty()) return {};
    return fmt::format("has OpenGL {}.{} and not 4.3{}", version / 10, version % 10,
                       version < least_gl_version ? "" : ", without " + missing);
}

std::string describe_context()
{
    const auto text = [](GLenum name) -> std::string {
        const GLubyte* value = glGetString(name);
        return value ? reinterpret_cast<const char*>(value) : "?";
    };
    return fmt::format("{}, {}, OpenGL {}", text(GL_VENDOR), text(GL_RENDERER), text(GL_VERSION));
}

bool is_software()
{
    std::string name = describe_context();
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const char* known : {"llvmpipe", "softpipe", "swrast", "software", "gdi generic"})
        if (name.find(known) != std::string::npos) return true;
    return false;
}

bool context_was_lost()
{
    if (epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness"))
        return glGetGraphicsResetStatus() != GL_NO_ERROR;
    if (epoxy_has_gl_extension("GL_ARB_robustness"))
        return glGetGraphicsResetStatusARB() != GL_NO_ERROR;
    return false;
}

} // namespace trivar::gpu
