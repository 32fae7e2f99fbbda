// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/each_name.h"

#include "core/commands/every_command.h"
#include "core/document/bases.h"
#include "core/document/fields/object_fields.h"
#include "core/document/named_files.h"
#include "tests/support/scenes/commands.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <regex>
#include <set>

namespace trivar {

struct Forgetful {
    int host = 0;
    std::vector<int> others = {};
    std::string file = {};
};
template <> struct FieldsOf<Forgetful> {
    static void fields(auto& f, auto&& field)
    {
        field("host", f.host, "what it is on");
        field("others", f.others, "ids of others", in_range(0, 9));
        field("file", f.file, "a picture");
    }
};

namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;

// Whether a copy of an object tells by name what a value of this type depends on, too: by its own
// list of fields, or in a list beside it. Commands are not copied.
template <class V> constexpr bool is_told_by_name()
{
    if constexpr (requires { V::verb; })
        return true;
    else if constexpr (requires { FieldsOf<V>::copied_as; })
        return true;
    else
        return std::is_same_v<V, NamedIncision> || std::is_same_v<V, ObstacleUse>;
}

struct Complaints {
    std::vector<std::string> said = {};
    std::set<std::string> seen = {};
};

// A number without bounds is an id, and a text is a file, unless its field says what it is.
template <class V>
void look_at(Complaints& out, const std::string& name, const Rule& rule, std::string_view help)
{
    const auto complain = [&](std::string_view what) {
        if (out.seen.insert(name).second) out.said.push_back(fmt::format("{} {}", name, what));
    };
    const bool says = !rule.no_name.empty();
    if constexpr (std::is_same_v<V, int> || std::is_same_v<V, std::vector<int>>) {
        static const std::regex id("\\bids?\\b");
        const bool bounded = rule.lo != Rule{}.lo || rule.hi != Rule{}.hi;
        if (!rule.object && !bounded && !says) complain("is any number: names_object()?");
        if (rule.object != std::regex_search(help.begin(), help.end(), id))
            complain("is an id by its rule or by its help: names_object()?");
    } else {
        if (rule.object || !rule.use.empty()) complain("is no id");
        if constexpr (std::is_same_v<V, std::string>)
            if (!rule.file && !rule.digest && rule.choices.empty() && !says &&
                !name.ends_with(".name"))
                complain("is any text: names_file()?");
    }
}

template <class V>
void look_into(Complaints& out, const std::string& name, const Rule& rule, std::string_view help)
{
    if constexpr (std::is_same_v<V, std::vector<int>>)
        look_at<V>(out, name, rule, help);
    else if constexpr (is_optional<V> || is_list<V>)
        look_into<typename V::value_type>(out, name, rule, help);
    else if constexpr (is_ref<V>)
        look_into<std::remove_const_t<typename V::element_type>>(out, name, rule, help);
    else if constexpr (is_choice<V>)
        [&]<class... One>(const std::variant<One...>*) {
            (look_into<One>(out, name, rule, help), ...);
        }(static_cast<const V*>(nullptr));
    else {
        look_at<V>(out, name, rule, help);
        if constexpr (Nested<V> || requires(V & v) { V::verb; }) {
            const V probe{};
            bool after_a_file = false;
            each_field(probe, [&]<class Inner>(std::string_view inner, const Inner&,
                                               std::string_view its_help,
                                               const Rule& its_rule = {}) {
                if (after_a_file != its_rule.digest)
                    out.said.push_back(fmt::format("{}.{}: a digest follows a file", name, inner));
                after_a_file = its_rule.file.has_value();
                if (!its_rule.use.empty() && !is_told_by_name<V>())
                    out.said.push_back(fmt::format("{}.{}: a copy names it by its id alone: "
                                                   "copied_as?",
                                                   name, inner));
                look_into<Inner>(out, fmt::format("{}.{}", name, inner), its_rule, its_help);
            });
            if (after_a_file) out.said.push_back(name + " has a file without a digest");
        }
    }
}

TEST(Names, OfObjectsAndFilesAreToldByTheFieldsOfAllThatASceneHolds)
{
    Complaints out;
    look_into<Object>(out, "object", {}, "");
    for (const Command& command : every_command())
        visit([&]<class C>(const C&) { look_into<C>(out, std::string(C::verb), {}, ""); }, command);
    EXPECT_THAT(out.said, IsEmpty());
}

TEST(Names, ThatAFieldForgetsAreSaid)
{
    Complaints out;
    look_into<Forgetful>(out, "forgetful", {}, "");
    EXPECT_THAT(out.said,
                ElementsAre("forgetful.host is any number: names_object()?",
                            "forgetful.others is an id by its rule or by its help: names_object()?",
                            "forgetful.file is any text: names_file()?"));
}

TEST(Names, AreReachedInListsOptionalsAndChoices)
{
    Object o;
    o.parent = 7;
    o.source = HeightShape{.image = "hills.png", .image_hash = "ab"};
    o.stroke.emplace().onto = {3, 4};
    o.tiles.emplace().base = 5;
    o.tiles->masks = {{.from = MaskFrom::line, .image = "kept.png"},
                      {.from = MaskFrom::image, .image = "spots.png"}};
    std::vector<Id> ids;
    each_id(o, [&](Id& id, const Rule&) { ids.push_back(id++); });
    EXPECT_THAT(ids, ElementsAre(7, 3, 4, 5, 0, 0, 0));
    EXPECT_THAT(o.stroke->onto, ElementsAre(4, 5));
    std::vector<std::string> read;
    for (const FileUse& use : files_named(o))
        read.push_back(fmt::format("{} {} {}", use.path, use.hash, use.mask));
    EXPECT_THAT(read, ElementsAre("hills.png ab 0", "spots.png  2"));
    const Bind bind{.objects = {1, 2}, .from = {3}, .to = 4};
    ids.clear();
    each_id(bind, [&](Id id, const Rule&) { ids.push_back(id); });
    EXPECT_THAT(ids, ElementsAre(1, 2, 3, 4));
}

TEST(Bases, ThatAreGoneTakeAlongOnlyWhatCannotBeWithoutThem)
{
    Object o;
    o.stroke.emplace().onto = {1, 2};
    o.stroke->attach = Attachment{{attached_host(1, glm::dmat4(1), true)}};
    o.splitting.emplace().obstacles = {{1}};
    o.incising.emplace().cuts.emplace_back().blade = 1;
    o.tiles.emplace().base = 1;
    o.tiles->others = {{1, 1}, {2, 3}};
    o.tiles->masks.emplace_back().curve = 1;
    const Object without = with_bases(o, [](Id id) { return id == 1 ? 0 : id; });
    EXPECT_THAT(without.stroke->onto, ElementsAre(2));
    EXPECT_FALSE(without.stroke->attach);
    EXPECT_FALSE(without.splitting);
    EXPECT_EQ(without.incising->cuts.front().blade, 0);
    EXPECT_EQ(without.tiles->base, 0);
    EXPECT_THAT(without.tiles->others, ElementsAre(MixedTile{2, 3}));
    EXPECT_EQ(without.tiles->masks.front().curve, 0);
    const Object merged = with_bases(o, [](Id) { return 2; });
    EXPECT_THAT(merged.stroke->onto, ElementsAre(2));
    EXPECT_EQ(merged.stroke->attach->hosts.front().object, 2);
    EXPECT_THAT(merged.tiles->others, ElementsAre(MixedTile{2, 1}));
}

} // namespace
} // namespace trivar
