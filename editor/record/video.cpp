// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/record/video.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/files/file_bytes.h"
#include "core/files/growing_file.h"
#include "core/files/pictures/image.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <functional>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char** environ;

namespace trivar {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t max_picture_bytes = std::uintmax_t{1} << 31;

bool has_program(const std::string& name)
{
    const char* const path = std::getenv("PATH");
    std::string_view folders = path ? path : "";
    while (!folders.empty()) {
        const std::size_t end = std::min(folders.find(':'), folders.size());
        const fs::path file = fs::path(folders.substr(0, end)) / name;
        std::error_code ignored;
        if (fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0) return true;
        folders.remove_prefix(std::min(end + 1, folders.size()));
    }
    return false;
}

// Returns the name of the format in ffmpeg.
std::string format_of(const std::string& path)
{
    const std::string extension = extension_of(path);
    return extension == ".mkv" ? "matroska" : extension.substr(1);
}

// Converts a format that has no end of its own in a stream, such as EXR, to PNG.
std::string as_png(const std::string& path, PictureReader& reader)
{
    if (extension_of(path) == ".png") return read_bytes(path, max_picture_bytes);
    return encoded_image(reader.read(path), ".png");
}

// A Child is a program that reads bytes from its standard input; its output goes nowhere.
class Child {
public:
    explicit Child(const std::vector<std::string>& arguments)
    {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw Rejected(std::strerror(errno));
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
        for (const int out : {STDOUT_FILENO, STDERR_FILENO})
            posix_spawn_file_actions_addopen(&actions, out, "/dev/null", O_WRONLY, 0);
        std::vector<char*> words;
        for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
        words.push_back(nullptr);
        const int error =
            ::posix_spawnp(&id_, words.front(), &actions, nullptr, words.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        ::close(ends[0]);
        to_ = ends[1];
        ::fcntl(to_, F_SETFL, O_NONBLOCK); // it may take its time
        if (error != 0) {
            ::close(to_);
            throw Rejected(
                fmt::format("{} cannot be started ({})", arguments.front(), std::strerror(error)));
        }
    }
    ~Child() // what is not awaited is ended
    {
        if (id_ < 0) return;
        if (to_ >= 0) ::close(to_);
        ::kill(id_, SIGKILL);
        while (::waitpid(id_, nullptr, 0) < 0 && errno == EINTR) continue;
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // Whether it took all of them. While it does not, `meanwhile` is called, which may throw.
    bool give(std::string_view bytes, const std::function<void()>& meanwhile)
    {
        while (!bytes.empty()) {
            const ssize_t count = ::write(to_, bytes.data(), bytes.size());
            if (count > 0) {
                bytes.remove_prefix(static_cast<std::size_t>(count));
                continue;
            }
            if (count < 0 && errno == EINTR) continue;
            if (count == 0 || errno != EAGAIN) return false;
            pollfd room{to_, POLLOUT, 0};
            ::poll(&room, 1, wait_ms);
            meanwhile();
        }
        return true;
    }
    // Waits for it; whether it was content.
    bool end(const std::function<void()>& meanwhile)
    {
        ::close(std::exchange(to_, -1));
        int status = 0;
        while (::waitpid(id_, &status, WNOHANG) == 0) {
            ::poll(nullptr, 0, wait_ms);
            meanwhile();
        }
        id_ = -1;
        return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }

private:
    static constexpr int wait_ms = 20;
    pid_t id_ = -1;
    int to_ = -1;
};

// A program that ends early must not end this one.
class WithoutPipeSignal {
public:
    WithoutPipeSignal()
    {
        struct sigaction ignoring {};
        ignoring.sa_handler = SIG_IGN;
        ::sigaction(SIGPIPE, &ignoring, &before_);
    }
    ~WithoutPipeSignal() { ::sigaction(SIGPIPE, &before_, nullptr); }
    WithoutPipeSignal(const WithoutPipeSignal&) = delete;
    WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

private:
    struct sigaction before_ {};
};

} // namespace

void check_video(const std::string& path)
{
    const std::string extension = extension_of(path);
    if (extension != ".mp4" && extension != ".mov" && extension != ".mkv")
        throw Rejected(fmt::format("{}: videos are written as .mp4, .mov or .mkv, not as '{}'",
                                   path, extension));
    if (!has_program("ffmpeg"))
        throw Rejected(path + ": videos are made by ffmpeg, which is not installed here "
                              "(Debian's package ffmpeg)");
}

void write_video(const std::vector<std::string>& pictures, double frames_per_second,
                 const std::string& path, const Progress& progress)
{
    check_video(path);
    GrowingFile file(fs::absolute(path).string());
    const std::vector<std::string> words{"ffmpeg",
                                         "-y",
                                         "-loglevel",
                                         "quiet",
                                         "-f",
                                         "image2pipe",
                                         "-framerate",
                                         shortest(frames_per_second),
                                         "-i",
                                         "-",
                                         "-vf",
                                         "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                         "-c:v",
                                         "libx264",
                                         "-crf",
                                         "16",
                                         "-pix_fmt",
                                         "yuv420p",
                                         "-movflags",
                                         "+faststart",
                                         "-f",
                                         format_of(path),
                                         file.for_others()};
    const WithoutPipeSignal no_signal;
    bool content = true;
    {
        Child ffmpeg(words);
        PictureReader reader;
        std::size_t given = 0;
        const auto tell = [&] {
            report(progress, static_cast<double>(given) / static_cast<double>(pictures.size()),
                   "video");
        };
        for (; given < pictures.size() && content; ++given) {
            tell();
            content = ffmpeg.give(as_png(pictures[given], reader), tell);
        }
        content = ffmpeg.end(tell) && content;
    }
    std::error_code ignored;
    content = content && fs::file_size(file.for_others(), ignored) > 0;
    if (!content) throw Rejected(path + ": ffmpeg could not make it of these pictures there");
    file.finish();
}

} // namespace trivar
