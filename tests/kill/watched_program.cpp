// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kill/watched_program.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>

namespace trivar::testing {
namespace {

// Copies the environment of this program except for the places of things.
std::vector<std::string> environment_of(const std::string& home, const std::string& screen)
{
    std::vector<std::string> all{"HOME=" + home, "XDG_STATE_HOME=" + home + "/state",
                                 "DISPLAY=" + screen};
    for (char** each = environ; *each; ++each) {
        const std::string_view line(*each);
        if (!line.starts_with("HOME=") && !line.starts_with("XDG_") &&
            !line.starts_with("DISPLAY=") && !line.starts_with("WAYLAND_DISPLAY=") &&
            !line.starts_with("TRIVAR_"))
            all.emplace_back(line);
    }
    return all;
}

std::vector<char*> pointers_to(std::vector<std::string>& words)
{
    std::vector<char*> all;
    for (std::string& word : words) all.push_back(word.data());
    all.push_back(nullptr);
    return all;
}

} // namespace

WatchedProgram::WatchedProgram(const std::vector<std::string>& files, const std::string& home,
                               const std::string& screen)
{
    std::vector<std::string> words{TRIVAR_BINARY_DIR "/trivar", "--tell-steps"};
    words.insert(words.end(), files.begin(), files.end());
    std::vector<std::string> environment = environment_of(home, screen);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions, home.c_str());
    if (::posix_spawn(&id_, words.front().c_str(), &actions, nullptr, pointers_to(words).data(),
                      pointers_to(environment).data()) != 0)
        id_ = -1;
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    told_ = ends[0];
    gone_ = id_ < 0;
}

WatchedProgram::~WatchedProgram()
{
    kill();
    wait_till_gone();
    if (told_ >= 0) ::close(told_);
}

bool WatchedProgram::listen(int patience_ms)
{
    pollfd told{told_, POLLIN, 0};
    if (gone_ || ::poll(&told, 1, patience_ms) <= 0) return false;
    std::array<char, 4096> bytes{};
    const ssize_t got = ::read(told_, bytes.data(), bytes.size());
    if (got <= 0) {
        gone_ = true;
        return false;
    }
    half_.append(bytes.data(), static_cast<std::size_t>(got));
    take_lines();
    return true;
}

void WatchedProgram::take_lines()
{
    for (std::size_t end = 0; (end = half_.find('\n')) != half_.npos; half_.erase(0, end + 1)) {
        const std::string line = half_.substr(0, end);
        Shown shown;
        int begins = 0;
        if (std::sscanf(line.c_str(), "shows %zu of %zu steps, %zu lines: %n", &shown.steps,
                        &shown.of, &shown.lines, &begins) != 3 ||
            begins == 0)
            continue;
        shown.path = line.substr(static_cast<std::size_t>(begins));
        shown_.push_back(std::move(shown));
    }
}

bool WatchedProgram::wait_for(const std::function<bool(const Shown&)>& is_so)
{
    const auto till = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    for (std::size_t heard = 0;;) {
        for (; heard < shown_.size(); ++heard)
            if (is_so(shown_[heard])) return true;
        if (gone_ || std::chrono::steady_clock::now() > till) return false;
        listen(1000);
    }
}

void WatchedProgram::wait_for_frames(int count)
{
    constexpr int moment_ms = 1000;
    const std::size_t wanted = shown_.size() + static_cast<std::size_t>(count);
    while (shown_.size() < wanted && listen(moment_ms)) {
    }
}

void WatchedProgram::kill()
{
    if (id_ > 0) ::kill(id_, SIGKILL);
}

void WatchedProgram::wait_till_gone()
{
    if (id_ <= 0) return;
    while (!gone_) listen(-1);
    ::waitpid(id_, nullptr, 0);
    id_ = -1;
}

} // namespace trivar::testing
