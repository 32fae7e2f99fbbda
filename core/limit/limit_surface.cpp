// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/limit_surface.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/unit.h"

#include <algorithm>
#include <fmt/format.h>
#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

namespace trivar {
namespace {

namespace Bfr = OpenSubdiv::Bfr;
namespace FarNet = OpenSubdiv::Far;
using Patch = Bfr::Surface<double>;

// Steps of subdivision round extraordinary vertices and semi-sharp creases. At two, tiles would sit
// visibly off a mesh that was subdivided further: by 1e-3 of the surface's size.
constexpr int approximation_level = 6;

std::unique_ptr<FarNet::TopologyRefiner> refiner_of(const Cage& cage)
{
    FarNet::TopologyDescriptor d;
    d.numVertices = static_cast<int>(cage.points.size());
    d.numFaces = static_cast<int>(cage.face_sizes.size());
    d.numVertsPerFace = cage.face_sizes.data();
    d.vertIndicesPerFace = cage.corners.data();
    d.numCreases = static_cast<int>(cage.crease_sharpness.size());
    d.creaseVertexIndexPairs = cage.crease_ends.data();
    d.creaseWeights = cage.crease_sharpness.data();
    d.numCorners = static_cast<int>(cage.point_sharpness.size());
    d.cornerVertexIndices = cage.sharp_points.data();
    d.cornerWeights = cage.point_sharpness.data();
    OpenSubdiv::Sdc::Options scheme; // as core/mesh/subdivide.cpp has it
    scheme.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    using Factory = FarNet::TopologyRefinerFactory<FarNet::TopologyDescriptor>;
    return std::unique_ptr<FarNet::TopologyRefiner>(
        Factory::Create(d, Factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK, scheme)));
}

struct MixedPoint { // what OpenSubdiv mixes
    glm::dvec3 value{0};
    void Clear(void* = nullptr) { value = glm::dvec3(0); }
    void AddWithWeight(const MixedPoint& other, double weight) { value += weight * other.value; }
};

// One step of subdivision; sharpness goes along. The points are left out.
Cage refined_once(FarNet::TopologyRefiner& refiner)
{
    FarNet::TopologyRefiner::UniformOptions options(1);
    options.fullTopologyInLastLevel =
        true; // else the queries of edges read what is no longer there
    refiner.RefineUniform(options);
    const FarNet::TopologyLevel& level = refiner.GetLevel(1);
    Cage out;
    out.points.resize(static_cast<std::size_t>(level.GetNumVertices()));
    for (int f = 0; f < level.GetNumFaces(); ++f) {
        const auto points = level.GetFaceVertices(f);
        out.face_sizes.push_back(points.size());
        for (int k = 0; k < points.size(); ++k) out.corners.push_back(points[k]);
    }
    for (int e = 0; e < level.GetNumEdges(); ++e)
        if (level.GetEdgeSharpness(e) > 0 && level.GetEdgeFaces(e).size() == 2) {
            const auto ends = level.GetEdgeVertices(e);
            out.crease_ends.insert(out.crease_ends.end(), {ends[0], ends[1]});
            out.crease_sharpness.push_back(level.GetEdgeSharpness(e));
        }
    for (int v = 0; v < level.GetNumVertices(); ++v)
        if (level.GetVertexSharpness(v) > 0 && level.GetVertexFaces(v).size() > 1) {
            out.sharp_points.push_back(v);
            out.point_sharpness.push_back(level.GetVertexSharpness(v));
        }
    return out;
}

const Patch::PointDescriptor three_numbers(3);

const double* numbers(const glm::dvec3* points)
{
    return &points->x;
}
double* numbers(glm::dvec3* points)
{
    return &points->x;
}

glm::dvec3 across_both(const LimitJet& jet)
{
    return glm::cross(jet.u, jet.v);
}

} // namespace

SurfaceFrame frame_of(const LimitJet& jet)
{
    const glm::dvec3 n = unit_or(across_both(jet), {0, 0, 1});
    const double e = glm::dot(jet.u, jet.u), f = glm::dot(jet.u, jet.v), g = glm::dot(jet.v, jet.v),
                 d = e * g - f * f;
    if (!(d > 0)) return {n, glm::dvec3(0), glm::dvec3(0)};
    const double l = glm::dot(jet.uu, n), m = glm::dot(jet.uv, n), o = glm::dot(jet.vv, n);
    // [N_u N_v] = -[P_u P_v] S with the shape operator S = I^-1 II
    const double s00 = (g * l - f * m) / d, s10 = (e * m - f * l) / d, s01 = (g * m - f * o) / d,
                 s11 = (e * o - f * m) / d;
    const double mean = (s00 + s11) / 2, gauss = s00 * s11 - s01 * s10,
                 apart = std::sqrt(std::max(0.0, mean * mean - gauss));
    return {n, -s00 * jet.u - s10 * jet.v, -s01 * jet.u - s11 * jet.v, mean + apart, mean - apart};
}

glm::dvec2 in_chart(const LimitJet& jet, const glm::dvec3& t)
{
    const double e = glm::dot(jet.u, jet.u), f = glm::dot(jet.u, jet.v), g = glm::dot(jet.v, jet.v),
                 d = e * g - f * f;
    if (!(d > 0)) return glm::dvec2(0);
    const double x = glm::dot(jet.u, t), y = glm::dot(jet.v, t);
    return {(g * x - f * y) / d, (e * y - f * x) / d};
}

struct LimitSurface::Topology {
    std::unique_ptr<FarNet::TopologyRefiner> coarse; // null: the cage has quads alone
    std::unique_ptr<FarNet::TopologyRefiner> refiner;
    std::unique_ptr<Bfr::RefinerSurfaceFactory<>> factory;
    std::vector<Patch> patches;     // #charts
    std::vector<std::size_t> first; // patch point of each chart; one more at the end
    ChartNet net{std::vector<ChartNet::Chart>{}};

    explicit Topology(const Cage& cage)
    {
        const bool quads = std::ranges::all_of(cage.face_sizes, [](int n) { return n == 4; });
        const std::size_t charts = quads ? cage.face_sizes.size() : cage.corners.size();
        if (charts > most_charts)
            throw Rejected(fmt::format("a limit surface of {} faces is too large; at most {} are "
                                       "possible",
                                       with_commas(charts), with_commas(most_charts)));
        refiner = refiner_of(cage);
        if (!refiner) throw Rejected("the cage's faces do not form a surface");
        Cage fine;
        if (!quads) {
            coarse = std::move(refiner);
            fine = refined_once(*coarse);
            refiner = refiner_of(fine);
            if (!refiner) throw Rejected("the cage's faces do not form a surface");
        }
        const Cage& own = quads ? cage : fine;
        net = ChartNet(own.corners, own.crease_ends);
        Bfr::SurfaceFactory::Options options;
        options.SetApproxLevelSmooth(approximation_level);
        options.SetApproxLevelSharp(approximation_level);
        factory = std::make_unique<Bfr::RefinerSurfaceFactory<>>(*refiner, options);
        patches.resize(charts);
        first.push_back(0);
        for (std::size_t c = 0; c < charts; ++c) {
            if (!factory->InitVertexSurface(static_cast<int>(c), &patches[c]))
                throw Rejected("the cage's faces do not form a surface");
            first.push_back(first.back() +
                            static_cast<std::size_t>(patches[c].GetNumPatchPoints()));
        }
    }

    std::vector<glm::dvec3> points_of_charts(std::span<const glm::dvec3> cage_points) const
    {
        if (!coarse) return {cage_points.begin(), cage_points.end()};
        std::vector<MixedPoint> from(cage_points.size()),
            to(static_cast<std::size_t>(coarse->GetLevel(1).GetNumVertices()));
        for (std::size_t i = 0; i < from.size(); ++i) from[i].value = cage_points[i];
        FarNet::PrimvarRefinerReal<double>(*coarse).Interpolate(1, from, to);
        std::vector<glm::dvec3> out;
        for (const MixedPoint& each : to) out.push_back(each.value);
        return out;
    }
};

LimitSurface::LimitSurface(const Cage& cage)
    : LimitSurface(std::make_shared<const Topology>(cage), cage.points)
{
}

LimitSurface::LimitSurface(std::shared_ptr<const Topology> topology,
                           std::span<const glm::dvec3> cage_points)
    : topology_(std::move(topology)),
      patch_points_(topology_->first.back())
{
    const std::vector<glm::dvec3> points = topology_->points_of_charts(cage_points);
    for (std::size_t c = 0; c < topology_->patches.size(); ++c)
        topology_->patches[c].PreparePatchPoints(numbers(points.data()), three_numbers,
                                                 numbers(&patch_points_[topology_->first[c]]),
                                                 three_numbers);
    Box box;
    for (const glm::dvec3& p : cage_points) box.add(p);
    if (!box.empty()) diagonal_ = glm::length(box.size());
}

LimitSurface LimitSurface::moved(std::span<const glm::dvec3> cage_points) const
{
    return LimitSurface(topology_, cage_points);
}

const ChartNet& LimitSurface::net() const
{
    return topology_->net;
}

bool LimitSurface::is_regular(std::uint32_t chart) const
{
    return topology_->patches[chart].IsRegular();
}

glm::dvec3 LimitSurface::position(const ChartPlace& at) const
{
    glm::dvec3 p(0);
    topology_->patches[at.chart].Evaluate(
        &at.uv.x, numbers(&patch_points_[topology_->first[at.chart]]), three_numbers, numbers(&p));
    return p;
}

LimitJet LimitSurface::jet(const ChartPlace& at) const
{
    LimitJet j{};
    topology_->patches[at.chart].Evaluate(
        &at.uv.x, numbers(&patch_points_[topology_->first[at.chart]]), three_numbers, numbers(&j.p),
        numbers(&j.u), numbers(&j.v), numbers(&j.uu), numbers(&j.uv), numbers(&j.vv));
    return j;
}

glm::dvec3 LimitSurface::normal(const ChartPlace& at) const
{
    const glm::dvec3 n = across_both(jet(at));
    if (const double length = glm::length(n); length > 1e-14 * diagonal_ * diagonal_)
        return n / length;
    // A corner without a tangent plane: from a little inside.
    return unit_or(across_both(jet({at.chart, at.uv + 1e-3 * (glm::dvec2(0.5) - at.uv)})),
                   {0, 0, 1});
}

} // namespace trivar
