// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/subdivide.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/mesh/cage.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <fmt/format.h>
#include <memory>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#include <opensubdiv/sdc/crease.h>

namespace trivar {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

constexpr double max_faces = 20e6;

// A WeightedSum is a value that OpenSubdiv interpolates. It is double, so that many levels add no
// error to the rounding of floats.
template <class V> struct WeightedSum {
    V value{0};
    void Clear(void* = nullptr) { value = V(0); }
    void AddWithWeight(const WeightedSum& other, float weight)
    {
        value += other.value * double(weight);
    }
};
using Point = WeightedSum<glm::dvec3>;
using Uv = WeightedSum<glm::dvec2>;
using Color = WeightedSum<glm::dvec4>;

// An Attribute has its indices by corner: equal values at one point are one value, so that they
// stay joined; different ones are a seam.
template <class V> struct Attribute {
    std::vector<int> corners; // #C to value
    std::vector<WeightedSum<V>> values;
};

template <class V, class Source>
Attribute<V> channel(const Mesh& mesh, const std::vector<Source>& source)
{
    std::vector<std::uint32_t> order(mesh.vertex_count());
    for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
        if (mesh.point(a) != mesh.point(b)) return mesh.point(a) < mesh.point(b);
        for (int i = 0; i < Source::length(); ++i)
            if (source[a][i] != source[b][i]) return source[a][i] < source[b][i];
        return a < b;
    };
    std::sort(order.begin(), order.end(), less);
    Attribute<V> result;
    std::vector<int> value_of(mesh.vertex_count());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::uint32_t v = order[i];
        if (i == 0 || mesh.point(order[i - 1]) != mesh.point(v) ||
            source[order[i - 1]] != source[v])
            result.values.push_back({V(source[v])});
        value_of[v] = static_cast<int>(result.values.size()) - 1;
    }
    for (const std::uint32_t v : mesh.corners) result.corners.push_back(value_of[v]);
    return result;
}

std::unique_ptr<Far::TopologyRefiner> refiner(const Cage& cage,
                                              const std::vector<const std::vector<int>*>& channels)
{
    using Descriptor = Far::TopologyDescriptor;
    Descriptor descriptor;
    descriptor.numVertices = static_cast<int>(cage.points.size());
    descriptor.numFaces = static_cast<int>(cage.face_sizes.size());
    descriptor.numVertsPerFace = cage.face_sizes.data();
    descriptor.vertIndicesPerFace = cage.corners.data();
    descriptor.numCreases = static_cast<int>(cage.crease_sharpness.size());
    descriptor.creaseVertexIndexPairs = cage.crease_ends.data();
    descriptor.creaseWeights = cage.crease_sharpness.data();
    descriptor.numCorners = static_cast<int>(cage.point_sharpness.size());
    descriptor.cornerVertexIndices = cage.sharp_points.data();
    descriptor.cornerWeights = cage.point_sharpness.data();
    std::vector<Descriptor::FVarChannel> fvar(channels.size());
    for (std::size_t i = 0; i < channels.size(); ++i) {
        fvar[i].numValues = 1 + *std::max_element(channels[i]->begin(), channels[i]->end());
        fvar[i].valueIndices = channels[i]->data();
    }
    descriptor.numFVarChannels = static_cast<int>(fvar.size());
    descriptor.fvarChannels = fvar.data();
    Sdc::Options scheme;
    scheme.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    scheme.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_CORNERS_ONLY);
    using Factory = Far::TopologyRefinerFactory<Descriptor>;
    return std::unique_ptr<Far::TopologyRefiner>(
        Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_CATMARK, scheme)));
}

// Returns the values of the last level.
template <class V, class Interpolate>
std::vector<WeightedSum<V>> refined(std::vector<WeightedSum<V>> values, int levels,
                                    Interpolate interpolate)
{
    for (int level = 1; level <= levels; ++level) values = interpolate(level, values);
    return values;
}

class Result {
public:
    Result(const Mesh& cage, Mesh& mesh, const Far::TopologyRefiner& refiner, int levels)
        : cage_(cage),
          mesh_(mesh),
          refiner_(refiner),
          last_(refiner.GetLevel(levels)),
          levels_(levels)
    {
    }

    // Adds a vertex for each different combination of a point and its values in the channels, in
    // the order of the points.
    void add_vertices(std::size_t channels)
    {
        stride_ = channels + 1;
        std::vector<int> keys; // per corner: point, values
        keys.reserve(static_cast<std::size_t>(last_.GetNumFaceVertices()) * stride_);
        for (int f = 0; f < last_.GetNumFaces(); ++f) {
            const Far::ConstIndexArray points = last_.GetFaceVertices(f);
            for (int c = 0; c < points.size(); ++c) {
                keys.push_back(points[c]);
                for (std::size_t i = 0; i < channels; ++i)
                    keys.push_back(last_.GetFaceFVarValues(f, static_cast<int>(i))[c]);
            }
            mesh_.face_begin.push_back(static_cast<std::uint32_t>(keys.size() / stride_));
        }
        const auto compare = [&](std::uint32_t a, std::uint32_t b) {
            const int* first = keys.data();
            return std::lexicographical_compare_three_way(
                first + a * stride_, first + (a + 1) * stride_, first + b * stride_,
                first + (b + 1) * stride_);
        };
        std::vector<std::uint32_t> order(keys.size() / stride_);
        for (std::uint32_t c = 0; c < order.size(); ++c) order[c] = c;
        std::sort(order.begin(), order.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return compare(a, b) < 0; });
        mesh_.corners.resize(order.size());
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (i == 0 || compare(order[i - 1], order[i]) != 0) {
                const int* key = keys.data() + order[i] * stride_;
                vertex_.insert(vertex_.end(), key, key + stride_);
                mesh_.points.push_back(static_cast<std::uint32_t>(key[0]));
                ++count;
            }
            mesh_.corners[order[i]] = count - 1;
        }
    }

    void place()
    {
        const Far::PrimvarRefinerReal<double> primvar(refiner_);
        std::vector<Point> points(point_count(cage_));
        for (std::uint32_t v = 0; v < cage_.vertex_count(); ++v)
            points[cage_.point(v)].value = glm::dvec3(cage_.positions[v]);
        points =
            refined(std::move(points), levels_, [&](int level, const std::vector<Point>& from) {
                std::vector<Point> to(
                    static_cast<std::size_t>(refiner_.GetLevel(level).GetNumVertices()));
                primvar.Interpolate(level, from, to);
                return to;
            });
        std::vector<Point> limit(points.size()), along(points.size()), across(points.size());
        primvar.Limit(points, limit, along, across);
        for (const std::uint32_t p : mesh_.points) {
            mesh_.positions.emplace_back(limit[p].value);
            const glm::dvec3 normal = glm::cross(along[p].value, across[p].value);
            const double length = glm::length(normal);
            const bool smooth = length > 0 && !on_hard_crease(static_cast<int>(p));
            mesh_.normals.push_back(smooth ? glm::vec3(normal / length) : glm::vec3(0));
        }
        // On a crease of infinite sharpness there are two limit normals, and at a corner of
        // infinite sharpness the tangents may be parallel: there the faces around the vertex
        // decide.
        const std::vector<glm::vec3> smooth = smooth_normals(mesh_);
        for (std::size_t v = 0; v < smooth.size(); ++v)
            if (mesh_.normals[v] == glm::vec3(0)) mesh_.normals[v] = smooth[v];
    }

    template <class V, class Target>
    std::vector<Target> values(std::vector<WeightedSum<V>> from, std::size_t channel) const
    {
        const Far::PrimvarRefinerReal<double> primvar(refiner_);
        const int number = static_cast<int>(channel);
        from = refined(
            std::move(from), levels_, [&](int level, const std::vector<WeightedSum<V>>& coarse) {
                std::vector<WeightedSum<V>> fine(
                    static_cast<std::size_t>(refiner_.GetLevel(level).GetNumFVarValues(number)));
                primvar.InterpolateFaceVarying(level, coarse, fine, number);
                return fine;
            });
        std::vector<WeightedSum<V>> limit(from.size());
        primvar.LimitFaceVarying(from, limit, number);
        std::vector<Target> result;
        for (std::size_t at = channel + 1; at < vertex_.size(); at += stride_)
            result.emplace_back(limit[static_cast<std::size_t>(vertex_[at])].value);
        return result;
    }

    // Returns the attributes of the faces, which each takes from its cage face.
    std::vector<std::uint32_t> inherited(const std::vector<std::uint32_t>& of_cage_face) const
    {
        if (of_cage_face.empty()) return {};
        std::vector<std::uint32_t> values = of_cage_face;
        for (int level = 1; level <= levels_; ++level) {
            const Far::TopologyLevel fine = refiner_.GetLevel(level);
            std::vector<std::uint32_t> next;
            for (int f = 0; f < fine.GetNumFaces(); ++f)
                next.push_back(values[static_cast<std::size_t>(fine.GetFaceParentFace(f))]);
            values = std::move(next);
        }
        return values;
    }

private:
    bool on_hard_crease(int point) const
    {
        for (const int edge : last_.GetVertexEdges(point))
            if (last_.GetEdgeFaces(edge).size() > 1 &&
                Sdc::Crease::IsInfinite(last_.GetEdgeSharpness(edge)))
                return true;
        return false;
    }

    const Mesh& cage_;
    Mesh& mesh_;
    const Far::TopologyRefiner& refiner_;
    Far::TopologyLevel last_;
    int levels_;
    std::vector<int> vertex_; // #V by stride_: point, value in each channel
    std::size_t stride_ = 1;
};

} // namespace

Mesh subdivide(const Mesh& cage, int levels, const Progress& progress)
{
    if (levels < 0 || levels > 6)
        throw Rejected(fmt::format("subdivision levels must be 0 to 6, not {}", levels));
    if (levels == 0 || cage.face_count() == 0) return cage;
    validate(cage, "the cage");
    // The first level makes a quad of every corner, each further one four of every quad.
    const double faces = static_cast<double>(cage.corners.size()) * std::pow(4.0, levels - 1);
    if (faces > max_faces)
        throw Rejected(fmt::format("{} levels would make {} faces; at most {} are allowed", levels,
                                   number_text(faces), number_text(max_faces)));
    const Mesh clean = ready_to_subdivide(cage);

    report(progress, 0, "Subdividing");
    std::vector<Attribute<glm::dvec2>> uvs;
    for (const auto& set : clean.uvs) uvs.push_back(channel<glm::dvec2>(clean, set));
    std::vector<Attribute<glm::dvec4>> colors;
    if (!clean.colors.empty()) colors.push_back(channel<glm::dvec4>(clean, clean.colors));
    std::vector<const std::vector<int>*> channels;
    for (const auto& set : uvs) channels.push_back(&set.corners);
    for (const auto& set : colors) channels.push_back(&set.corners);
    const auto refined_topology = refiner(cage_of(clean), channels);
    if (!refined_topology) throw Rejected("the cage's faces do not form a surface");
    Far::TopologyRefiner::UniformOptions options(levels);
    options.fullTopologyInLastLevel = true;
    refined_topology->RefineUniform(options);

    report(progress, 0.4, "Subdividing");
    Mesh mesh;
    Result result(clean, mesh, *refined_topology, levels);
    result.add_vertices(channels.size());
    report(progress, 0.6, "Subdividing");
    result.place();
    for (std::size_t i = 0; i < uvs.size(); ++i)
        mesh.uvs.push_back(result.values<glm::dvec2, glm::vec2>(std::move(uvs[i].values), i));
    if (!colors.empty())
        mesh.colors = result.values<glm::dvec4, glm::vec4>(std::move(colors[0].values), uvs.size());
    mesh.face_material = result.inherited(clean.face_material);
    mesh.face_group = result.inherited(clean.face_group);
    mesh.group_names = clean.group_names;
    report(progress, 1, "Subdividing");
    return mesh;
}

} // namespace trivar
