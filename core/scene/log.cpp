// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/log.h"

#include "core/base/text.h"
#include "core/commands/json_text.h"
#include "core/commands/read_json.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

using nlohmann::json;

// A stroke of a thousand samples takes 50 kB. JSON in memory is about thirty times its text.
constexpr std::size_t longest_line = std::size_t{16} << 20;
constexpr int largest_frame = 999'999; // as in set_time

void check_header(const json& header)
{
    if (!header.contains("trivar"))
        throw Rejected("this is not a Trivar scene: its first line has no field \"trivar\"");
    const json& version = header["trivar"];
    if (!version.is_number_integer() || version < 1)
        throw Rejected(
            "field \"trivar\", the version of the format, must be a whole number of at least 1");
    if (version > log_version)
        throw Rejected(fmt::format("the file has format version {}, newer than this program's {}; "
                                   "open it with a newer Trivar",
                                   version.dump(), log_version));
    for (const auto& [name, value] : header.items())
        if (name == "units" && value != "m")
            throw Rejected("field \"units\" must be \"m\"");
        else if (name == "up" && value != "z")
            throw Rejected("field \"up\" must be \"z\"");
        else if (name != "trivar" && name != "units" && name != "up")
            throw Rejected(fmt::format("field \"{}\" is unknown in a header", excerpt(name)));
}

std::string taken_digest(json& object, const std::string& name)
{
    if (!object.contains(name)) return {};
    std::string digest = text_field(object, name);
    if (digest.size() != 32 || digest.find_first_not_of("0123456789abcdef") != digest.npos)
        throw Rejected(fmt::format("field \"{}\" must be 32 hexadecimal digits", name));
    object.erase(name);
    return digest;
}

std::optional<int> taken_frame(json& object)
{
    if (!object.contains("frame")) return {};
    const double frame = object["frame"].is_number_integer() ? object["frame"].get<double>() : NAN;
    if (!(std::abs(frame) <= largest_frame))
        throw Rejected(
            fmt::format("field \"frame\" must be a whole number from -{0} to {0}", largest_frame));
    object.erase("frame");
    return static_cast<int>(frame);
}

std::string taken_note(json& object)
{
    if (!object.contains("note")) return {};
    std::string note = text_field(object, "note");
    const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
    if (note.size() > longest_note || std::ranges::any_of(note, is_control))
        throw Rejected(fmt::format("field \"note\" must be one paragraph of at most {} bytes, "
                                   "without control characters",
                                   longest_note));
    object.erase("note");
    return note;
}

LogLine read_line(json object)
{
    LogLine line;
    line.digest = taken_digest(object, "digest");
    line.effects = taken_digest(object, "effects");
    const bool digests = !line.digest.empty() || !line.effects.empty();
    if (!line.effects.empty() && !object.contains("do")) line.frame = taken_frame(object);
    if (object.contains("do")) {
        line.note = taken_note(object);
        line.what = command_from(object);
    } else if (object == json{{"undo", true}})
        line.what = UndoLine{};
    else if (object == json{{"redo", true}})
        line.what = RedoLine{};
    else if (object.empty() && digests)
        line.what = CheckLine{};
    else
        throw Rejected("the line must be a command ({\"do\":...}), {\"undo\":true}, "
                       "{\"redo\":true} or a digest");
    return line;
}

std::string_view without_return(std::string_view line)
{
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

} // namespace

Log read_log(std::string_view text, const std::string& name)
{
    Log log;
    log.name = name;
    int number = 0;
    bool header_seen = false;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t line_break = text.find('\n', begin);
        const bool whole = line_break != text.npos;
        const std::size_t end = whole ? line_break : text.size();
        const std::string_view line = without_return(text.substr(begin, end - begin));
        ++number;
        try {
            if (line.size() > longest_line) throw Rejected("the line is longer than 16 MiB");
            if (line.find_first_not_of(" \t") != line.npos) {
                json object;
                try {
                    object = parse_object(line);
                } catch (const Rejected&) {
                    if (whole || !header_seen) throw;
                    log.notice = fmt::format(
                        "{}:{}: the last line is incomplete, as after a crash, and was left out",
                        name, number);
                    return log;
                }
                if (header_seen)
                    log.lines.emplace_back(read_line(std::move(object))).number = number;
                else
                    check_header(object);
                header_seen = true;
            }
        } catch (const Rejected& error) {
            throw Rejected(fmt::format("{}:{}: {}", name, number, error.what()));
        }
        begin = whole ? end + 1 : end;
        log.good_bytes = begin;
        log.ends_with_break = whole;
    }
    if (!header_seen)
        throw Rejected(fmt::format("{}:1: the file is empty, so it is not a Trivar scene", name));
    return log;
}

std::string without_last_lines(std::string text, std::size_t count)
{
    for (; count > 0 && text.size() > 1; --count) {
        const std::size_t end = text.rfind('\n', text.size() - 2);
        if (end == std::string::npos) break;
        text.resize(end + 1);
    }
    return text;
}

std::vector<std::string> lines_of(std::string_view text)
{
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

LogLine read_log_line(std::string_view line)
{
    if (line.size() > longest_line) throw Rejected("the line is longer than 16 MiB");
    return read_line(parse_object(line));
}

void apply(History& history, const LogLine& line, const std::string& name)
{
    try {
        if (const auto* command = std::get_if<Command>(&line.what))
            history.run(*command, line.note);
        else if (std::holds_alternative<UndoLine>(line.what)) {
            if (!history.undo()) throw Rejected("there is nothing to undo here");
        } else if (std::holds_alternative<RedoLine>(line.what)) {
            if (!history.redo()) throw Rejected("there is nothing to redo here");
        }
    } catch (const Rejected& error) {
        throw Rejected(fmt::format("{}:{}: {}", name, line.number, error.what()));
    }
}

History replay(const Log& log)
{
    History history;
    for (const LogLine& line : log.lines) apply(history, line, log.name);
    return history;
}

std::string log_header()
{
    return fmt::format("{{\"trivar\":{},\"units\":\"m\",\"up\":\"z\"}}\n", log_version);
}

std::string command_line(const Command& command, const std::string& note)
{
    std::string line = to_json_line(command);
    if (!note.empty()) line.insert(line.size() - 1, ",\"note\":" + json_text(note));
    return line + "\n";
}

std::string undo_line()
{
    return "{\"undo\":true}\n";
}

std::string redo_line()
{
    return "{\"redo\":true}\n";
}

std::string check_line(const std::string& digest, const std::string& effects,
                       std::optional<int> frame)
{
    std::string fields;
    if (!digest.empty()) fields += "\"digest\":" + json_text(digest);
    if (!effects.empty())
        fields += (fields.empty() ? "" : ",") + ("\"effects\":" + json_text(effects));
    if (frame) fields += fmt::format(",\"frame\":{}", *frame);
    return "{" + fields + "}\n";
}

std::string log_text(const History& history)
{
    std::string text = log_header();
    history.retell(
        [&](const History::Step& step) { text += command_line(step.command, step.note); },
        [&] { text += undo_line(); });
    return text;
}

std::string compact_log_text(const History& history)
{
    std::string text = log_header();
    for (std::size_t i = 0; i < history.position(); ++i)
        text += command_line(history.steps()[i].command, history.steps()[i].note);
    return text;
}

} // namespace trivar
