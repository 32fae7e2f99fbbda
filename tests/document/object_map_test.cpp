// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

TEST(ObjectMap, HoldsWhatAMapHoldsInItsOrder)
{
    std::mt19937 random(1);
    ObjectMap map;
    std::map<int, Ref<Object>> expected;
    for (int i = 0; i < 3000; ++i) {
        const int id = static_cast<int>(random() % 500);
        if (random() % 3 == 0) {
            map.erase(id);
            expected.erase(id);
        } else {
            const Ref<Object> value = make_ref(Object{});
            map.set(id, value);
            expected[id] = value;
        }
        ASSERT_EQ(map.size(), expected.size());
        ASSERT_EQ(map.contains(id), expected.contains(id));
    }
    EXPECT_EQ((std::map<int, Ref<Object>>(map.begin(), map.end())), expected);
}

TEST(ObjectMap, CopiesDoNotSeeEachOthersChanges)
{
    ObjectMap first;
    Object one;
    one.name = "one";
    first.set(1, make_ref(one));
    ObjectMap second = first;
    second.set(2, make_ref(Object{}));
    second.erase(1);
    EXPECT_EQ(first.size(), 1u);
    EXPECT_EQ(first.at(1)->name, "one");
    EXPECT_FALSE(second.contains(1));
}

TEST(ObjectMap, IsEmptyWhenAllIsErased)
{
    ObjectMap map;
    map.set(70, make_ref(Object{}));
    map.erase(70);
    map.erase(70);
    EXPECT_TRUE(map.empty());
    EXPECT_EQ(map.begin(), map.end());
    EXPECT_EQ(map.find(-1), map.end());
}

} // namespace
} // namespace trivar
