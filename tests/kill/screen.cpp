// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kill/screen.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/keysym.h>
#include <array>
#include <cassert>
#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace trivar::testing {
namespace {

struct Server {
    pid_t id = -1;
    std::string name{":"}; // and its number
};

// It chooses a free number, and says which when it listens.
Server start_server()
{
    constexpr int told_at = 3;
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return {};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    // The number must differ: with the same one it would stay closed for the other program.
    const int end = ::fcntl(ends[1], F_DUPFD_CLOEXEC, told_at + 1);
    posix_spawn_file_actions_adddup2(&actions, end, told_at);
    std::array<std::string, 8> words{"Xvfb", "-displayfd",  "3",         "-screen",
                                     "0",    "1440x900x24", "-nolisten", "tcp"};
    std::array<char*, 9> arguments{};
    for (std::size_t i = 0; i < words.size(); ++i) arguments.at(i) = words.at(i).data();
    Server server;
    const int trouble =
        ::posix_spawnp(&server.id, "Xvfb", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    ::close(end);
    if (trouble != 0) server.id = -1;
    char digit = 0;
    while (server.id > 0 && ::read(ends[0], &digit, 1) == 1 && digit != '\n') server.name += digit;
    ::close(ends[0]);
    return server;
}

} // namespace

struct Screen::State {
    Server server;
    Display* display = nullptr;
    ::Time time_ms = 1; // of the keyboard
    pid_t known = -1;   // the program whose window was looked for last
    Window window = 0;

    Window window_of(pid_t program)
    {
        if (known == program && window != 0) return window;
        known = program;
        window = 0;
        Window root = 0, parent = 0, *all = nullptr;
        unsigned count = 0;
        XQueryTree(display, DefaultRootWindow(display), &root, &parent, &all, &count);
        for (unsigned i = 0; i < count; ++i)
            if (owner(all[i]) == program) window = all[i];
        if (all) XFree(all);
        return window;
    }
    pid_t owner(Window of) const
    {
        const Atom name = XInternAtom(display, "_NET_WM_PID", False);
        Atom kind = 0;
        int bits = 0;
        unsigned long count = 0, more = 0;
        unsigned char* value = nullptr;
        pid_t found = -1;
        if (XGetWindowProperty(display, of, name, 0, 1, False, XA_CARDINAL, &kind, &bits, &count,
                               &more, &value) == Success &&
            value && count == 1)
            found = static_cast<pid_t>(*reinterpret_cast<const unsigned long*>(value));
        if (value) XFree(value);
        return found;
    }
    void send(Window to, KeySym key, unsigned held, bool down)
    {
        constexpr ::Time apart_ms = 25; // less would be taken for a key that repeats itself
        XEvent event{};
        XKeyEvent& k = event.xkey;
        k.type = down ? KeyPress : KeyRelease;
        k.display = display;
        k.window = to;
        k.root = DefaultRootWindow(display);
        k.time = time_ms += apart_ms;
        k.state = held;
        k.keycode = XKeysymToKeycode(display, key);
        k.same_screen = True;
        XSendEvent(display, to, True, down ? KeyPressMask : KeyReleaseMask, &event);
    }
};

Screen::Screen() : state_(std::make_unique<State>()) {}

std::unique_ptr<Screen> Screen::open()
{
    std::unique_ptr<Screen> screen(new Screen);
    State& s = *screen->state_;
    s.server = start_server();
    if (s.server.name == ":") return nullptr;
    s.display = XOpenDisplay(s.server.name.c_str());
    if (!s.display) return nullptr;
    // The window of a killed program may be gone by now.
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    return screen;
}

Screen::~Screen()
{
    if (state_->display) XCloseDisplay(state_->display);
    if (state_->server.id <= 0) return;
    ::kill(state_->server.id, SIGTERM);
    ::waitpid(state_->server.id, nullptr, 0);
}

const std::string& Screen::name() const
{
    return state_->server.name;
}

bool Screen::shows(pid_t program)
{
    return state_->window_of(program) != 0;
}

void Screen::strike(pid_t program, const Stroke& stroke)
{
    State& s = *state_;
    const Window to = s.window_of(program);
    if (to == 0) return;
    struct Held {
        bool is = false;
        KeySym key = 0;
        unsigned mask = 0;
    };
    const std::array<Held, 3> beside{{{stroke.ctrl, XK_Control_L, ControlMask},
                                      {stroke.shift, XK_Shift_L, ShiftMask},
                                      {stroke.alt, XK_Alt_L, Mod1Mask}}};
    const KeySym key = XStringToKeysym(stroke.key.c_str());
    assert(key != NoSymbol);
    unsigned held = 0;
    for (const Held& each : beside) {
        if (!each.is) continue;
        s.send(to, each.key, held, true);
        held |= each.mask;
    }
    s.send(to, key, held, true);
    s.send(to, key, held, false);
    for (const Held& each : beside) {
        if (!each.is) continue;
        s.send(to, each.key, held, false);
        held &= ~each.mask;
    }
    XFlush(s.display);
}

} // namespace trivar::testing
