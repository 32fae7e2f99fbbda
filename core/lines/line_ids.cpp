// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/line_ids.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace trivar {
namespace {

constexpr float record_step = 1;  // voxels between points of a record
constexpr float record_reach = 2; // voxels that a line may have moved aside
constexpr int oldest = 8;         // drawings that a line is remembered for

// PointGrid finds the record of the nearest of many points.
class PointGrid {
public:
    explicit PointGrid(const std::vector<LineRecord>& records)
    {
        for (std::uint32_t r = 0; r < records.size(); ++r)
            for (const glm::vec3& p : records[r].points)
                entries_.push_back({key(cell(p)), r, p, records[r].hidden});
        std::ranges::sort(entries_, {}, [](const Entry& e) { return std::pair(e.key, e.record); });
    }
    // The record of the nearest point of a kind within reach; -1: none.
    std::int64_t nearest(const glm::vec3& p, bool hidden) const
    {
        float least = record_reach * record_reach;
        std::int64_t out = -1;
        const glm::ivec3 middle = cell(p);
        for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y) {
                const std::uint64_t first = key(middle + glm::ivec3(-1, y, z));
                for (auto e = std::ranges::lower_bound(entries_, first, {}, &Entry::key);
                     e != entries_.end() && e->key <= first + 2; ++e) {
                    const glm::vec3 d = e->p - p;
                    if (e->hidden != hidden || !(glm::dot(d, d) < least)) continue;
                    least = glm::dot(d, d);
                    out = e->record;
                }
            }
        return out;
    }

private:
    struct Entry {
        std::uint64_t key;
        std::uint32_t record;
        glm::vec3 p;
        bool hidden;
    };
    static glm::ivec3 cell(const glm::vec3& p)
    {
        return glm::ivec3(glm::floor(p / record_reach)) + 2; // lines may leave the grid a little
    }
    static std::uint64_t key(const glm::ivec3& c)
    {
        const auto u = [](int i) { return static_cast<std::uint64_t>(std::max(0, i)); };
        return u(c.x) | u(c.y) << 21 | u(c.z) << 42;
    }
    std::vector<Entry> entries_;
};

// A Claim is how many voxels of a stroke lie along a record.
struct Claim {
    std::size_t count, stroke, record;
};

} // namespace

LineRecord record_of(const Stroke& stroke)
{
    LineRecord out{stroke.id, stroke.hidden, {}};
    for (const StrokePoint& point : stroke.points)
        if (out.points.empty() || glm::distance(out.points.back(), point.p) >= record_step)
            out.points.push_back(point.p);
    return out;
}

void LineIds::operator()(std::span<std::vector<Stroke>> kinds)
{
    std::vector<Stroke*> strokes;
    for (std::vector<Stroke>& kind : kinds)
        for (Stroke& stroke : kind) strokes.push_back(&stroke);
    std::vector<LineRecord> records;
    for (const Stroke* stroke : strokes) records.push_back(record_of(*stroke));

    const PointGrid grid(before_);
    std::vector<Claim> claims;
    for (std::size_t s = 0; s < records.size() && !before_.empty(); ++s) {
        std::map<std::size_t, std::size_t> along; // by record
        for (const glm::vec3& p : records[s].points)
            if (const std::int64_t r = grid.nearest(p, records[s].hidden); r >= 0)
                ++along[static_cast<std::size_t>(r)];
        for (const auto& [record, count] : along) claims.push_back({count, s, record});
    }
    std::ranges::sort(claims, {}, [](const Claim& c) {
        return std::tuple(~c.count, c.stroke, c.record); // most first
    });
    std::vector<char> known(strokes.size(), 0), given(before_.size(), 0);
    std::set<std::pair<bool, std::uint64_t>> used;
    for (const Claim& claim : claims) {
        if (known[claim.stroke] || given[claim.record]) continue;
        known[claim.stroke] = given[claim.record] = 1;
        strokes[claim.stroke]->id = before_[claim.record].id;
        used.insert({before_[claim.record].hidden, before_[claim.record].id});
    }
    for (std::size_t r = 0; r < before_.size(); ++r) // those that are not drawn now
        if (!given[r]) used.insert({before_[r].hidden, before_[r].id});
    for (std::size_t s = 0; s < strokes.size(); ++s) {
        if (!known[s])
            while (!used.insert({strokes[s]->hidden, strokes[s]->id}).second) ++strokes[s]->id;
        records[s].id = strokes[s]->id;
    }
    std::vector<int> age(records.size(), 0);
    for (std::size_t r = 0; r < before_.size(); ++r) {
        if (given[r] || age_[r] + 1 >= oldest) continue;
        records.push_back(std::move(before_[r]));
        age.push_back(age_[r] + 1);
    }
    before_ = std::move(records);
    age_ = std::move(age);
}

} // namespace trivar
