// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "gpu/context.h"
#include "ui/gui.h"

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar::ui {
namespace {

[[noreturn]] void reject_glfw(const std::string& what)
{
    const char* why = nullptr;
    glfwGetError(&why);
    throw Rejected(what + (why ? ": " + std::string(why) : std::string()) + ".");
}

struct Library { // GLFW itself
    Library()
    {
        if (!glfwInit()) reject_glfw("No window can be opened (trivar replay needs none)");
    }
    ~Library() { glfwTerminate(); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
};

GLFWwindow* open_window(const WindowOptions& options)
{
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET); // where it is offered
    GLFWwindow* window = nullptr;
    for (const int version : {43, gpu::least_gl_version}) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, version / 10);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, version % 10);
        window = glfwCreateWindow(options.size.x, options.size.y, options.title.c_str(), nullptr,
                                  nullptr);
        if (window) break;
    }
    if (!window)
        reject_glfw(fmt::format("No window with OpenGL 3.3 can be opened; {}", gpu::better_opengl));
    glfwMakeContextCurrent(window);
    if (const std::string lacking = gpu::lacking(); !lacking.empty()) {
        glfwDestroyWindow(window);
        throw Rejected(fmt::format("The window {}; {}.", lacking, gpu::better_opengl));
    }
    glfwSwapInterval(1);
    return window;
}

} // namespace

std::optional<double> scale_override(double asked)
{
    if (asked > 0) return std::clamp(asked, 0.75, 3.0);
    const char* text = std::getenv("TRIVAR_SCALE");
    const std::optional<double> scale = parse_number(text ? text : "");
    if (scale && *scale > 0) return std::clamp(*scale, 0.75, 3.0);
    return std::nullopt;
}

struct Window::State {
    Library library;
    GLFWwindow* window;
    WindowOptions options;
    Gui gui;
    Pace pace;
    std::array<GLFWcursor*, ImGuiMouseCursor_COUNT> cursors{};
    int cursor = -2;
    std::string title; // where it was set
    double interface_scale = 1;
    Look look;
    bool full_screen = false;
    glm::ivec2 windowed_at{0}, windowed_size{0}; // before it was full screen
    std::atomic<bool> woken = false;             // by another thread
    double listened_s = 0;                       // till when events were asked for
    double deaf_s = 0;                           // how long none were, before this time
    double heard_all_s = 0;                      // those that had waited have been heard of by then

    explicit State(const WindowOptions& wanted)
        : window(open_window(wanted)),
          options(wanted),
          gui({wanted_scale(), {}})
    {
        make_cursors();
        adopt_window();
    }
    void adopt_window()
    {
        glfwSetWindowUserPointer(window, this);
        limit_size();
        listen();
        ImGuiIO& io = ImGui::GetIO();
        io.ClipboardUserData = window;
        io.GetClipboardTextFn = [](void* w) {
            return glfwGetClipboardString(static_cast<GLFWwindow*>(w));
        };
        io.SetClipboardTextFn = [](void* w, const char* text) {
            glfwSetClipboardString(static_cast<GLFWwindow*>(w), text);
        };
    }
    // Keeps the window as large as the panels need side by side, but no larger than the screen.
    void limit_size()
    {
        glm::vec2 scale(1);
        glfwGetWindowContentScale(window, &scale.x, &scale.y);
        glm::ivec2 smallest(glm::round(glm::vec2(1024, 700) * glm::max(scale, glm::vec2(1))));
        if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
            glm::ivec2 at(0), room(0);
            glfwGetMonitorWorkarea(monitor, &at.x, &at.y, &room.x, &room.y);
            if (room.x > 0 && room.y > 0) smallest = glm::min(smallest, room);
        }
        glfwSetWindowSizeLimits(window, smallest.x, smallest.y, GLFW_DONT_CARE, GLFW_DONT_CARE);
    }
    ~State()
    {
        for (GLFWcursor* c : cursors)
            if (c) glfwDestroyCursor(c);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    // Another window with another context where this one was.
    void replace_window()
    {
        gui.forget_gpu();
        show_full_screen(false);
        glm::ivec2 at(0), size(0);
        glfwGetWindowPos(window, &at.x, &at.y);
        glfwGetWindowSize(window, &size.x, &size.y);
        glfwDestroyWindow(window);
        window = open_window(options);
        glfwSetWindowPos(window, at.x, at.y);
        glfwSetWindowSize(window, size.x, size.y);
        if (!title.empty()) glfwSetWindowTitle(window, title.c_str());
        adopt_window();
        cursor = -2;
        pace.input_came();
    }

    // Framebuffer pixels a window coordinate.
    float density() const
    {
        int w = 0, h = 0, fw = 0, fh = 0;
        glfwGetWindowSize(window, &w, &h);
        glfwGetFramebufferSize(window, &fw, &fh);
        return w > 0 && fw > 0 ? static_cast<float>(fw) / static_cast<float>(w) : 1.0f;
    }

    float wanted_scale() const
    {
        float x = 1, y = 1;
        glfwGetWindowContentScale(window, &x, &y);
        const double content = scale_override(options.scale).value_or(x);
        return combined_scale(content, interface_scale);
    }

    // The whole of the monitor that most of the window lies on, and back to where it was.
    void show_full_screen(bool wanted)
    {
        if (wanted == full_screen) return;
        full_screen = wanted;
        if (!wanted) {
            const glm::ivec2 at = windowed_at, size = windowed_size;
            glfwSetWindowMonitor(window, nullptr, at.x, at.y, size.x, size.y, GLFW_DONT_CARE);
            return;
        }
        glfwGetWindowPos(window, &windowed_at.x, &windowed_at.y);
        glfwGetWindowSize(window, &windowed_size.x, &windowed_size.y);
        GLFWmonitor* monitor = monitor_under(windowed_at + windowed_size / 2);
        const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
        if (!mode) return;
        glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }
    static GLFWmonitor* monitor_under(glm::ivec2 point)
    {
        int count = 0;
        GLFWmonitor** all = glfwGetMonitors(&count);
        for (int i = 0; i < count; ++i) {
            glm::ivec2 at;
            glfwGetMonitorPos(all[i], &at.x, &at.y);
            const GLFWvidmode* mode = glfwGetVideoMode(all[i]);
            if (mode && point.x >= at.x && point.y >= at.y && point.x < at.x + mode->width &&
                point.y < at.y + mode->height)
                return all[i];
        }
        return glfwGetPrimaryMonitor();
    }

    // Queues an event; one that comes while a frame is drawn is handled after it.
    void push(Event event)
    {
        constexpr double most_s = 0.4;
        event.time_s = glfwGetTime();
        event.doubt_s = std::min(event.time_s < heard_all_s ? deaf_s : 0.0, most_s);
        gui.input().push(std::move(event));
        pace.input_came();
    }

    static State& of(GLFWwindow* window)
    {
        return *static_cast<State*>(glfwGetWindowUserPointer(window));
    }

    void listen() const
    {
        glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
            const float d = of(w).density();
            of(w).push(move_to(glm::vec2(x, y) * d));
        });
        glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
            if (!entered) of(w).push(move_to(glm::vec2(-1e6f)));
        });
        glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
            of(w).push(press(static_cast<Button>(button), action == GLFW_PRESS));
        });
        glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
            of(w).push({.kind = Event::Kind::wheel, .at = {x, y}, .paths = {}});
        });
        glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int code, int action, int) {
            if (action == GLFW_REPEAT || key == GLFW_KEY_UNKNOWN) return; // ImGui repeats itself
            // Letters are meant as they are printed on this keyboard, not where QWERTY has them.
            const char* name = glfwGetKeyName(key, code);
            if (name && name[0] >= 'a' && name[0] <= 'z' && name[1] == 0) key = name[0] - 'a' + 'A';
            if (name && (name[0] == '+' || name[0] == '-' || name[0] == ',') && name[1] == 0)
                key = static_cast<unsigned char>(name[0]);
            of(w).push(press_key(key, action == GLFW_PRESS));
        });
        glfwSetCharCallback(window,
                            [](GLFWwindow* w, unsigned letter) { of(w).push(type_text(letter)); });
        glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int gained) {
            of(w).push({.kind = Event::Kind::focus, .down = gained != 0, .paths = {}});
        });
        glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
            of(w).push(drop_files({paths, paths + count}));
        });
        const auto redraw = [](GLFWwindow* w) { of(w).pace.input_came(); };
        glfwSetWindowContentScaleCallback(
            window, [](GLFWwindow* w, float, float) { of(w).pace.input_came(); });
        glfwSetWindowRefreshCallback(window, redraw);
        glfwSetWindowCloseCallback(window, redraw);
        glfwSetFramebufferSizeCallback(window,
                                       [](GLFWwindow* w, int, int) { of(w).pace.input_came(); });
    }

    void make_cursors()
    {
        const auto make = [this](ImGuiMouseCursor name, int shape) {
            cursors[static_cast<std::size_t>(name)] = glfwCreateStandardCursor(shape);
        };
        make(ImGuiMouseCursor_Arrow, GLFW_ARROW_CURSOR);
        make(ImGuiMouseCursor_TextInput, GLFW_IBEAM_CURSOR);
        make(ImGuiMouseCursor_ResizeNS, GLFW_VRESIZE_CURSOR);
        make(ImGuiMouseCursor_ResizeEW, GLFW_HRESIZE_CURSOR);
        make(ImGuiMouseCursor_Hand, GLFW_HAND_CURSOR);
        // ImGui has no cross, and we have no use for its "not allowed": the tools' cursor.
        make(ImGuiMouseCursor_NotAllowed, GLFW_CROSSHAIR_CURSOR);
    }

    void show_cursor()
    {
        const int wanted = ImGui::GetMouseCursor();
        if (wanted == cursor || wanted < 0) return;
        cursor = wanted;
        GLFWcursor* shape = cursors[static_cast<std::size_t>(wanted)];
        glfwSetCursor(window, shape ? shape : cursors[ImGuiMouseCursor_Arrow]);
    }

    void sleep_until_due()
    {
        constexpr double delivery_s = 2e-3; // of all that waited
        const double wait = gui.input().pending() ? 0 : pace.wait_s(glfwGetTime());
        deaf_s = glfwGetTime() - listened_s;
        heard_all_s = glfwGetTime() + delivery_s;
        if (wait <= 0)
            glfwPollEvents();
        else if (wait > 1e9)
            glfwWaitEvents();
        else
            glfwWaitEventsTimeout(wait);
        listened_s = glfwGetTime();
        if (woken.exchange(false)) pace.result_came(glfwGetTime());
    }

    // Draws if a frame is due; whether the program goes on.
    bool step(const DrawFrame& body, const std::function<void()>& forget)
    {
        sleep_until_due();
        if (gpu::context_was_lost()) {
            forget();
            replace_window();
        }
        const bool closing = glfwWindowShouldClose(window);
        if (!closing && !gui.input().pending() && pace.wait_s(glfwGetTime()) > 0) return true;
        int w = 0, h = 0;
        glfwGetFramebufferSize(window, &w, &h);
        if ((w <= 0 || h <= 0) && !closing) { // minimised: nothing to draw into
            glfwWaitEvents();
            return true;
        }
        const ThemeOptions theme{wanted_scale(), look};
        if (theme.scale != gui.theme().scale || theme.look != gui.theme().look)
            gui.set_theme(theme);
        const Frame frame =
            gui.frame({std::max(w, 1), std::max(h, 1)}, glfwGetTime(), closing, [&body](Frame& f) {
                body(f);
                glBindFramebuffer(GL_FRAMEBUFFER, 0);
            });
        glfwSetWindowShouldClose(window, GLFW_FALSE);
        pace.drawn(frame);
        show_cursor();
        glfwSwapBuffers(window);
        if (frame.interface_scale != interface_scale || frame.look != look) pace.input_came();
        look = frame.look;
        interface_scale = frame.interface_scale;
        show_full_screen(frame.full_screen);
        return !frame.close;
    }
};

Window::Window(const WindowOptions& options) : state_(std::make_unique<State>(options)) {}
Window::~Window() = default;

void Window::run(const DrawFrame& body, const std::function<void()>& forget)
{
    while (state_->step(body, forget)) {
    }
}

std::function<void()> Window::waker() const
{
    return [state = state_.get()] {
        state->woken = true;
        glfwPostEmptyEvent();
    };
}

void Window::set_title(const std::string& title)
{
    state_->title = title;
    glfwSetWindowTitle(state_->window, title.c_str());
}

} // namespace trivar::ui
