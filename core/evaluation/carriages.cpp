// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/carriages.h"

#include "core/base/box.h"
#include "core/placement/view.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double same = 1e-9; // of the lengths at hand: no motion is told from rounding below it

glm::dvec3 at(const glm::dmat4& matrix, const glm::dvec3& p)
{
    return glm::dvec3(matrix * glm::dvec4(p, 1));
}

// The parts of an object in its own space: of those that a lattice bent or that were split since,
// as they are in the world now.
std::vector<Part> own_parts(const EvaluatedObject& object)
{
    const auto same_mesh = [](const Part& a, const Part& b) {
        return a.rest == b.rest && a.posed == b.posed && !a.bent == !b.bent;
    };
    if (std::ranges::equal(object.own_parts, object.parts, same_mesh)) return object.own_parts;
    std::vector<Part> out = object.parts;
    if (object.own_to_world == glm::dmat4(1)) return out;
    const glm::dmat4 back = glm::inverse(object.own_to_world);
    for (Part& part : out) part.to_world = back * part.to_world;
    return out;
}

// A host as it is now.
struct Now {
    const AttachedHost* host;
    const EvaluatedObject* object; // null: it is not there, or shows nothing
    std::vector<Part> parts;       // in its own space
    glm::dmat4 stood{1}, moved{1}; // how it stood; from there to where it stands
    glm::dmat4 own_to_drawn{1};    // as it is in the space of the stroke
    bool unmoved = false;          // it stands there as it did
};

struct Foot { // of a sample
    std::optional<FootPlace> now;
    glm::dvec3 drawn{0}; // in the space of the stroke
};

// All that one carriage is found from.
class Finder {
public:
    Finder(const PlacementStep& step, const std::vector<Ref<EvaluatedObject>>& hosts,
           Footings& footings, const StepInput& input);
    Carriage found(const std::vector<Ref<EvaluatedObject>>& others);

private:
    void find_motion(Carriage& carriage);
    void stand(Carriage& carriage, bool exact);
    void carry_samples(Carriage& carriage) const;
    void tell_gaps(Carriage& carriage, const std::vector<glm::dvec3>& places) const;
    bool alike(const glm::dmat4& a, const glm::dmat4& b) const;
    bool feet_unmoved() const;
    glm::dmat4 nearest_motion(const glm::dmat4& from) const;
    const Now& host_of(std::size_t sample) const
    {
        return hosts_[static_cast<std::size_t>(attachment_.samples[sample].host)];
    }

    const PlacementStep& step_;
    const Attachment& attachment_;
    std::vector<Now> hosts_;
    std::size_t main_;
    std::vector<Foot> feet_; // by sample
    Box drawn_;              // round the feet on the main host as they were drawn
};

Finder::Finder(const PlacementStep& step, const std::vector<Ref<EvaluatedObject>>& hosts,
               Footings& footings, const StepInput& input)
    : step_(step),
      attachment_(*step.attach),
      main_(main_host(attachment_)),
      feet_(attachment_.samples.size())
{
    for (std::size_t h = 0; h < hosts.size(); ++h) {
        Now now{&attachment_.hosts[h], nullptr, {}, attachment_.hosts[h].stood()};
        if (hosts[h] && !hosts[h]->parts.empty()) {
            now.object = hosts[h].get();
            now.parts = own_parts(*hosts[h]);
            now.moved = now.object->own_to_world == now.stood
                            ? glm::dmat4(1)
                            : now.object->own_to_world * glm::inverse(now.stood);
        }
        hosts_.push_back(std::move(now));
    }
    for (std::size_t i = 0; i < feet_.size(); ++i) {
        const AttachedSample& sample = attachment_.samples[i];
        if (sample.host < 0) continue;
        const Now& now = host_of(i);
        if (now.object) feet_[i].now = footings(sample, i, *now.object, now.parts, input);
        feet_[i].drawn = at(now.stood, sample.drawn);
        if (static_cast<std::size_t>(sample.host) == main_) drawn_.add(feet_[i].drawn);
    }
    if (drawn_.empty())
        for (const Part& part : hosts_[main_].parts)
            for (const glm::dvec3& corner : part.bounds.corners())
                drawn_.add(at(hosts_[main_].stood * part.to_world, corner));
}

// Whether two motions take what lies there to the same places.
bool Finder::alike(const glm::dmat4& a, const glm::dmat4& b) const
{
    return std::ranges::all_of(drawn_.corners(), [&](const glm::dvec3& p) {
        const glm::dvec3 q = at(a, p);
        return glm::distance(q, at(b, p)) <=
               same * (glm::length(drawn_.size()) + glm::length(p) + glm::length(q));
    });
}

// Whether the places under the stroke are where they were in the main host's own space.
bool Finder::feet_unmoved() const
{
    Box own;
    for (const AttachedSample& sample : attachment_.samples)
        if (sample.host == static_cast<int>(main_)) own.add(sample.drawn);
    const double slack =
        own.empty()
            ? 0
            : 10 * same * (glm::length(own.size()) + glm::length(own.lo) + glm::length(own.hi));
    for (std::size_t i = 0; i < feet_.size(); ++i)
        if (attachment_.samples[i].host == static_cast<int>(main_) && feet_[i].now &&
            glm::distance(feet_[i].now->p, attachment_.samples[i].drawn) > slack)
            return false;
    return true;
}

// Turn and shift of the places under the stroke, of their normals too, in the space of the stroke,
// where `from` takes it to the world.
glm::dmat4 Finder::nearest_motion(const glm::dmat4& from) const
{
    const Now& main = hosts_[main_];
    const glm::dmat4 now_to_drawn = glm::inverse(from) * main.object->own_to_world;
    const glm::dmat3 normal_then = glm::transpose(glm::inverse(glm::dmat3(main.stood))),
                     normal_now = glm::transpose(glm::inverse(glm::dmat3(now_to_drawn)));
    const double reach = std::max(glm::length(drawn_.size()) / 2, 1e-12);
    const auto out_by = [&](const glm::dvec3& normal) {
        const double length = glm::length(normal);
        return length > 0 ? normal * (reach / length) : glm::dvec3(0);
    };
    std::vector<glm::dvec3> a, b;
    for (std::size_t i = 0; i < feet_.size(); ++i) {
        const AttachedSample& sample = attachment_.samples[i];
        if (sample.host != static_cast<int>(main_) || !feet_[i].now) continue;
        const glm::dvec3 now = at(now_to_drawn, feet_[i].now->p);
        a.push_back(feet_[i].drawn);
        b.push_back(now);
        a.push_back(feet_[i].drawn + out_by(normal_then * sample.normal));
        b.push_back(now + out_by(normal_now * feet_[i].now->normal));
    }
    if (a.empty()) return glm::dmat4(1);
    return best_motion(a, b);
}

void Finder::find_motion(Carriage& carriage)
{
    const Now& main = hosts_[main_];
    const bool even = even_scale(main.moved).has_value();
    const glm::dmat4 from = even ? main.moved : glm::dmat4(1);
    const bool exact = even && feet_unmoved();
    carriage.to_world = exact ? from : from * nearest_motion(from);
    if (alike(carriage.to_world, glm::dmat4(1))) carriage.to_world = glm::dmat4(1);
    stand(carriage, exact);
}

// Where the hosts stand in the space of the stroke.
void Finder::stand(Carriage& carriage, bool exact)
{
    const glm::dmat4 back = glm::inverse(carriage.to_world);
    for (Now& now : hosts_) {
        if (!now.object) continue;
        now.unmoved = exact && alike(now.moved, carriage.to_world);
        now.own_to_drawn = now.unmoved ? now.stood : back * now.object->own_to_world;
        if (!now.unmoved && !now.host->touched) continue;
        for (Part part : now.parts) {
            part.to_world = now.own_to_drawn * part.to_world;
            carriage.supports.push_back(support_of(*now.object, std::move(part), now.own_to_drawn));
        }
    }
}

// The picture made larger on all sides, so that samples outside are in it.
void widen(Sketch& sketch)
{
    glm::dvec2 lo(0), hi = sketch.camera.size_px;
    for (const StrokeSample& sample : sketch.samples) {
        lo = glm::min(lo, sample.p_px);
        hi = glm::max(hi, sample.p_px);
    }
    const glm::dvec2 more = glm::max(-lo, hi - sketch.camera.size_px);
    if (more == glm::dvec2(0)) return;
    Camera& camera = sketch.camera;
    const double higher = (camera.size_px.y + 2 * more.y) / camera.size_px.y;
    camera.fov_y = 2 * std::atan(std::tan(camera.fov_y / 2) * higher);
    camera.height_world *= higher;
    camera.size_px += 2.0 * more;
    for (StrokeSample& sample : sketch.samples) sample.p_px += more;
}

// What samples between others that are known go by, in even steps, and those before and behind as
// the next one.
void fill_between(std::vector<glm::dvec2>& by, const std::vector<char>& known)
{
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < by.size(); ++i)
        if (known[i]) at.push_back(i);
    if (at.empty()) return;
    for (std::size_t i = 0; i < by.size(); ++i) {
        if (known[i]) continue;
        const auto next = std::ranges::upper_bound(at, i);
        if (next == at.begin())
            by[i] = by[at.front()];
        else if (next == at.end())
            by[i] = by[at.back()];
        else {
            const std::size_t a = *(next - 1), b = *next;
            const double share = static_cast<double>(i - a) / static_cast<double>(b - a);
            by[i] = glm::mix(by[a], by[b], share);
        }
    }
}

void Finder::carry_samples(Carriage& carriage) const
{
    Sketch& sketch = carriage.sketch;
    if (feet_.size() != sketch.samples.size()) return;
    const View view(sketch.camera);
    std::vector<glm::dvec2> by(feet_.size(), glm::dvec2(0));
    std::vector<char> known(feet_.size(), 0);
    std::vector<glm::dvec3> places(feet_.size());
    bool any = false;
    for (std::size_t i = 0; i < feet_.size(); ++i) {
        if (!feet_[i].now) continue;
        const Now& now = host_of(i);
        places[i] = now.unmoved ? feet_[i].drawn : at(now.own_to_drawn, feet_[i].now->p);
        known[i] = 1;
        if (now.unmoved) continue;
        const PicturePoint then = view.project(feet_[i].drawn), here = view.project(places[i]);
        known[i] = then.depth_world > 0 && here.depth_world > 0;
        by[i] = known[i] ? here.p_px - then.p_px : glm::dvec2(0);
        any = any || by[i] != glm::dvec2(0);
    }
    tell_gaps(carriage, places);
    if (!any) return;
    fill_between(by, known);
    for (std::size_t i = 0; i < by.size(); ++i) sketch.samples[i].p_px += by[i];
    widen(sketch);
}

// Hosts that moved apart leave a gap where the stroke goes from one to the other.
void Finder::tell_gaps(Carriage& carriage, const std::vector<glm::dvec3>& places) const
{
    double length = 0, widest = 0;
    std::size_t before = feet_.size();
    for (std::size_t i = 0; i < feet_.size(); ++i) {
        if (!feet_[i].now) continue;
        if (before < feet_.size()) {
            const double then = glm::distance(feet_[before].drawn, feet_[i].drawn),
                         now = glm::distance(places[before], places[i]);
            length += then;
            if (attachment_.samples[before].host != attachment_.samples[i].host)
                widest = std::max(widest, now - then);
        }
        before = i;
    }
    constexpr double much = 0.1; // of the stroke
    if (widest > much * length)
        carriage.notices.push_back(fmt::format(
            "the objects that carry it have moved apart by {:.3g} m; it bridges the gap", widest));
}

Carriage Finder::found(const std::vector<Ref<EvaluatedObject>>& others)
{
    Carriage out;
    out.sketch = step_.sketch;
    if (!hosts_[main_].object) {
        out.shown = false;
        out.notices.emplace_back("what carries it is not shown in this frame");
        return out;
    }
    find_motion(out);
    carry_samples(out);
    if (!out.moved()) // what it was not attached to is met while nothing moved
        for (const Ref<EvaluatedObject>& other : others)
            if (other)
                for (const Part& part : other->parts)
                    out.supports.push_back(support_of(*other, part, other->own_to_world));
    return out;
}

} // namespace

Support support_of(const EvaluatedObject& object, Part part, const glm::dmat4& own_to_drawn)
{
    const Ref<Mesh> rest = rest_mesh(*object.shape, part.key.mesh);
    return {object.id, std::move(part), rest, own_to_drawn};
}

Ref<Carriage> Carriages::operator()(const StepInput& input)
{
    const std::optional<PlacementStep>& step = input.object.placement;
    if (!step || !step->attach || step->round) return nullptr;
    From from{*step, {}, {}};
    const auto done = [&](Id id) {
        const auto found = input.done.find(id);
        return found == input.done.end() ? nullptr : found->second;
    };
    for (const AttachedHost& host : step->attach->hosts) from.hosts.push_back(done(host.object));
    for (const Id id : step->onto)
        if (std::ranges::find(step->attach->hosts, id, &AttachedHost::object) ==
            step->attach->hosts.end())
            from.others.push_back(done(id));
    return known_(from, [&] {
        return make_ref(Finder(from.step, from.hosts, footings_, input).found(from.others));
    });
}

} // namespace trivar
