// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/scene/log.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::StartsWith;

std::string rejection(const std::string& text)
{
    try {
        replay(read_log(text, "a.trivar"));
    } catch (const Rejected& error) {
        return error.what();
    }
    return "";
}

std::string line_rejection(const std::string& line)
{
    return rejection(log_header() + line + "\n");
}

TEST(Log, ReplaysUndoAndRedoLines)
{
    const History history =
        replay(read_log(log_header() + command_line(AddBox{}) + command_line(AddSphere{}) +
                            undo_line() + undo_line() + redo_line(),
                        "a.trivar"));
    EXPECT_EQ(history.steps().size(), 2u);
    EXPECT_EQ(history.position(), 1u);
    EXPECT_EQ(history.document().objects.size(), 1u);
}

TEST(Log, OfAHistoryGivesTheHistoryBackWithWhatIsUndone)
{
    History history;
    history.run(AddBox{});
    history.run(AddTorus{});
    history.undo();
    const History again = replay(read_log(log_text(history), "a.trivar"));
    EXPECT_EQ(again.position(), 1u);
    EXPECT_EQ(again.steps().size(), 2u);
    EXPECT_EQ(replay(read_log(compact_log_text(history), "a.trivar")).steps().size(), 1u);
}

TEST(Log, WritesNumbersAsShortAsTheyReadBack)
{
    SetMaterial command{.objects = {1}, .surfacing = {.base_color = {0.1f, 0.2f, 0.7f, 1}}};
    EXPECT_THAT(to_json_line(command), HasSubstr("\"base_color\":[0.1,0.2,0.7,1]"));
    const Command negative_zero = SetTransform{1, {.translation = {-0.0, 0.1, 1e-300}}};
    const auto back =
        command_from_json_line(to_json_line(negative_zero)).get<SetTransform>().transform;
    EXPECT_TRUE(std::signbit(back.translation.x));
    EXPECT_EQ(back.translation.z, 1e-300);
}

TEST(Log, NamesLineAndFieldOfWhatItRefuses)
{
    EXPECT_THAT(line_rejection(R"({"do":"fly"})"),
                StartsWith("a.trivar:2: there is no command \"fly\""));
    EXPECT_THAT(line_rejection(R"({"do":"rename","object":1})"), HasSubstr("\"name\" is missing"));
    EXPECT_THAT(line_rejection(R"({"do":"rename","object":"1","name":"a"})"),
                HasSubstr("\"object\" must be a whole number, not \"1\""));
    EXPECT_THAT(line_rejection(R"({"do":"rename","object":1.5,"name":"a"})"),
                HasSubstr("whole number"));
    EXPECT_THAT(line_rejection(R"({"do":"rename","object":99999999999999999999,"name":"a"})"),
                HasSubstr("whole number"));
    EXPECT_THAT(line_rejection(R"({"do":"rename","object":7,"name":"a"})"),
                HasSubstr("no object 7"));
    EXPECT_THAT(line_rejection(R"({"do":"add_box","size":[1,2]})"), HasSubstr("list of 3 numbers"));
    EXPECT_THAT(line_rejection(R"({"do":"add_box","size":[1,2,NaN]})"),
                HasSubstr("not valid JSON"));
    EXPECT_THAT(line_rejection(R"({"do":"add_box","size":[1,2,1e999]})"), HasSubstr("too large"));
    EXPECT_THAT(line_rejection(R"({"do":"add_box","sise":[1,2,3]})"),
                HasSubstr("\"sise\" is unknown"));
    EXPECT_THAT(line_rejection(R"({"do":"add_box","name":"a","name":"b"})"), HasSubstr("twice"));
    EXPECT_THAT(line_rejection(R"({"do":"add_box","transform":{"scale":1}})"),
                HasSubstr("\"transform.scale\""));
    EXPECT_THAT(line_rejection(R"({"do":"import","path":"a.obj","up":"x"})"),
                HasSubstr("auto, y, z"));
    EXPECT_THAT(line_rejection(R"({"undo":true})"), HasSubstr("nothing to undo"));
    EXPECT_THAT(line_rejection(R"({"redo":true})"), HasSubstr("nothing to redo"));
    EXPECT_THAT(line_rejection(R"({"undo":1})"), HasSubstr("must be a command"));
    EXPECT_THAT(line_rejection(R"([1])"), HasSubstr("object in braces"));
    EXPECT_THAT(line_rejection(R"({"digest":"12"})"), HasSubstr("32 hexadecimal digits"));
    EXPECT_THAT(line_rejection(std::string(1000, '[')), HasSubstr("too deeply"));
}

TEST(Log, NestsAsDeepAsItsFieldsDoAndNoDeeper)
{
    const std::string keys = R"([{"object":1,"tracks":[{"parameter":"hidden","keys":[)"
                             R"({"frame":1,"value":1,"before":[0,0]},{"frame":2,"value":0}]}]}])";
    EXPECT_EQ(rejection(log_header() + command_line(AddBox{}) + R"({"do":"animate","of":)" + keys +
                        "}\n"),
              "");
    EXPECT_THAT(line_rejection(R"({"do":[[[[[[[[[[]]]]]]]]]]})"), HasSubstr("a text in quotes"));
    EXPECT_THAT(line_rejection(R"({"do":[[[[[[[[[[[]]]]]]]]]]]})"), HasSubstr("too deeply"));
}

TEST(Log, TellsTheSameFieldTwiceWhereverItStands)
{
    const auto twice = HasSubstr("field \"scale\" appears twice");
    EXPECT_THAT(line_rejection(R"({"do":"add_box","transform":{"scale":[1,1,1],"scale":1}})"),
                twice);
    EXPECT_THAT(line_rejection(R"({"do":"add_box","a":[{"scale":1},{"scale":1,"scale":[{}]}]})"),
                twice);
    EXPECT_THAT(line_rejection(R"({"do":"add_box","a":[{"scale":1},{"scale":1}]})"),
                HasSubstr("\"a\" is unknown"));
}

TEST(Log, RefusesWhatIsNoSceneAndWhatIsNewer)
{
    EXPECT_THAT(rejection(""), HasSubstr("empty"));
    EXPECT_THAT(rejection("v 1 2 3\n"), HasSubstr("a.trivar:1: not valid JSON"));
    EXPECT_THAT(rejection("{\"a\":1}\n"), HasSubstr("not a Trivar scene"));
    EXPECT_THAT(rejection("{\"trivar\":2}\n"), HasSubstr("newer"));
    EXPECT_THAT(rejection("{\"trivar\":1,\"units\":\"ft\"}\n"), HasSubstr("\"units\""));
    EXPECT_THAT(rejection("{\"trivar\":1,\"wings\":2}\n"), HasSubstr("\"wings\""));
}

TEST(Log, DropsATornLastLineAtEveryLengthAndSaysSo)
{
    const std::string whole = log_header() + command_line(AddBox{});
    const std::string last = command_line(Rename{1, "Table"});
    for (std::size_t length = 1; length + 1 < last.size(); ++length) {
        const Log log = read_log(whole + last.substr(0, length), "a.trivar");
        EXPECT_EQ(log.lines.size(), 1u);
        EXPECT_THAT(log.notice, HasSubstr("a.trivar:3:"));
        EXPECT_EQ(log.good_bytes, whole.size());
    }
}

TEST(Log, TakesAWholeLastLineWithoutItsBreakAndBlankLines)
{
    const std::string line = command_line(AddBox{});
    const Log log = read_log(log_header() + "\n" + line.substr(0, line.size() - 1), "a.trivar");
    EXPECT_EQ(log.lines.size(), 1u);
    EXPECT_EQ(log.lines.front().number, 3);
    EXPECT_EQ(log.notice, "");
    EXPECT_FALSE(log.ends_with_break);
}

TEST(Log, CutAtAnyByteIsReadOrRefused)
{
    std::string text = log_header();
    for (const Command& command : testing::fitting_commands()) text += command_line(command);
    for (std::size_t length = 0; length < text.size(); ++length) {
        try {
            read_log(text.substr(0, length), "a.trivar");
        } catch (const Rejected& error) {
            EXPECT_THAT(error.what(), StartsWith("a.trivar:"));
        }
    }
}

TEST(Log, KeepsTheAuthorsNotesWhenItIsWrittenAnew)
{
    const std::string note = "Press `@Place`, then \"draw\" across it \xe2\x80\x93 slowly.";
    const std::string text = log_header() + command_line(AddBox{}, note) + command_line(AddTorus{});
    const History history = replay(read_log(text, "a.trivar"));
    EXPECT_EQ(history.steps()[0].note, note);
    EXPECT_EQ(history.steps()[1].note, "");
    EXPECT_EQ(log_text(history), text);
    EXPECT_EQ(compact_log_text(history), text);
}

TEST(Log, RefusesANoteThatIsNoParagraphOfACommand)
{
    const auto noted = [](const std::string& note) {
        return line_rejection("{\"do\":\"add_box\",\"note\":" + note + "}");
    };
    EXPECT_EQ(noted('"' + std::string(longest_note, 'a') + '"'), "");
    const std::string why = "a.trivar:2: field \"note\" must be one paragraph of at most 1024 "
                            "bytes, without control characters";
    EXPECT_EQ(noted('"' + std::string(longest_note + 1, 'a') + '"'), why);
    EXPECT_EQ(noted("\"two\\nlines\""), why);
    EXPECT_EQ(noted("\"\\u0000\""), why);
    EXPECT_EQ(noted("\"\\u001b[31mred\""), why);
    EXPECT_THAT(noted("12"), HasSubstr("field \"note\""));
    EXPECT_THAT(noted("\"\xff\""), HasSubstr("a.trivar:2: "));
    EXPECT_THAT(line_rejection("{\"undo\":true,\"note\":\"back\"}"),
                HasSubstr("must be a command"));
}

TEST(Log, CarriesDigests)
{
    const std::string text = log_header() + check_line(std::string(32, 'a'), std::string(32, 'b'));
    const Log log = read_log(text, "a.trivar");
    EXPECT_EQ(log.lines.front().digest, std::string(32, 'a'));
    EXPECT_EQ(log.lines.front().effects, std::string(32, 'b'));
    EXPECT_EQ(log.lines.front().frame, std::nullopt);
    const std::string in_frame = check_line("", std::string(32, 'b'), -48);
    EXPECT_EQ(read_log(log_header() + in_frame, "a").lines.front().frame, -48);
    for (const char* frame : {"1.5", "1e9", "null", "\"1\"", "99999999999999999999"})
        EXPECT_THAT(line_rejection("{\"effects\":\"" + std::string(32, 'b') +
                                   "\",\"frame\":" + frame + "}"),
                    HasSubstr("field \"frame\" must be a whole number"));
}

} // namespace
} // namespace trivar
