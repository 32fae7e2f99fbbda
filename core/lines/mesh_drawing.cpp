// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/mesh_drawing.h"

#include "core/base/key_numbers.h"
#include "core/base/parallel.h"
#include "core/lines/stroke_ends.h"
#include "core/silhouette/edge_chains.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr float point_spacing = 0.004f;  // of the size: no piece of a line is longer
constexpr float spacing_on_copy = 0.05f; // the same, where many bodies are one mesh
constexpr float off_surface = 2e-4f;     // of the size, from where a point is looked at
constexpr float beside_chord = 0.25f;    // of side times turn, twice the height of an arc over it
constexpr float shortest_on_mesh = 12;   // pixels, of lines that are no outlines
constexpr float meeting = 2;             // pixels between an end and the line at which it ends

// An Outlook is a place from which a point of a line is looked at.
struct Outlook {
    glm::vec3 normal{0};
    float height = 0; // along the normal
    float reach = 0;  // on the way to the eye, within which the own triangles hide nothing
};

// Lines with an outlook for each point.
struct ProbedLines {
    Silhouettes lines;
    std::vector<Outlook> outlooks;
};

// The lines with points no further apart than a spacing, without those that are not before the
// eye.
ProbedLines refined(const ProbedLines& from, float spacing, const glm::dmat4& to_image)
{
    ProbedLines out;
    std::size_t begin = 0;
    const auto end_curve = [&](bool closed) {
        if (out.lines.points.size() - begin < 2) {
            out.lines.points.resize(begin);
            out.outlooks.resize(begin);
            return;
        }
        begin = out.lines.points.size();
        out.lines.first.push_back(static_cast<std::uint32_t>(begin));
        out.lines.closed.push_back(closed);
    };
    const auto is_before_eye = [&](const glm::vec3& p) {
        return (to_image * glm::dvec4(glm::dvec3(p), 1)).w > 1e-6;
    };
    for (std::size_t c = 0; c < from.lines.count(); ++c) {
        bool whole = from.lines.closed[c];
        const std::uint32_t first = from.lines.first[c], last = from.lines.first[c + 1];
        const auto add = [&](const SilhouettePoint& point, const Outlook& outlook) {
            if (is_before_eye(point.p)) {
                out.lines.points.push_back(point);
                out.outlooks.push_back(outlook);
                return;
            }
            whole = false;
            end_curve(false);
        };
        for (std::uint32_t i = first; i < last; ++i) {
            const bool ends = i + 1 == last;
            add(from.lines.points[i], from.outlooks[i]);
            if (ends && !from.lines.closed[c]) break;
            const std::uint32_t next = ends ? first : i + 1;
            const SilhouettePoint &a = from.lines.points[i], &b = from.lines.points[next];
            const Outlook &at_a = from.outlooks[i], &at_b = from.outlooks[next];
            const float length = glm::distance(a.p, b.p);
            const int steps = std::max(1, static_cast<int>(std::ceil(length / spacing)));
            for (int k = 1; k < steps; ++k) {
                const float t = static_cast<float>(k) / static_cast<float>(steps);
                SilhouettePoint point = a;
                point.p = glm::mix(a.p, b.p, t);
                point.bend = glm::mix(a.bend, b.bend, t);
                point.strength = glm::mix(a.strength, b.strength, t);
                add(point, {glm::mix(at_a.normal, at_b.normal, t),
                            std::max(at_a.height, at_b.height), std::max(at_a.reach, at_b.reach)});
            }
            // A loop that was cut goes on to its first point.
            if (ends && !whole) add(b, at_b);
        }
        end_curve(whole);
    }
    return out;
}

ProbedLines on_surface(const SurfaceShape& surface, Silhouettes lines, bool grazing)
{
    ProbedLines out{std::move(lines), {}};
    for (const SilhouettePoint& point : out.lines.points) {
        const auto a = static_cast<std::size_t>(point.edge >> 32),
                   b = static_cast<std::size_t>(point.edge & 0xFFFFFFFF);
        const float side = glm::distance(surface.positions[a], surface.positions[b]),
                    turn = glm::distance(surface.normals[a], surface.normals[b]);
        const float to_a = glm::distance(point.p, surface.positions[a]),
                    share = side > 0 ? std::min(1.0f, to_a / side) : 0;
        out.outlooks.push_back({glm::mix(surface.normals[a], surface.normals[b], share),
                                off_surface * surface.size + beside_chord * side * turn,
                                grazing ? side : 0});
    }
    return out;
}

ProbedLines on_edges(const MeshShape& shape, std::span<const MeshShape::Edge> edges)
{
    KeyNumbers numbers(edges.size());
    for (std::uint32_t e = 0; e < edges.size(); ++e)
        numbers.insert(edge_key(edges[e].a, edges[e].b), e);
    ProbedLines out{edge_lines(shape.points, edges), {}};
    for (const SilhouettePoint& point : out.lines.points) {
        const MeshShape::Edge& edge = edges[numbers.find(point.edge)];
        out.outlooks.push_back({edge.first + edge.second, off_surface * shape.surface.size, 0});
    }
    return out;
}

// LineLook makes strokes of lines that lie on a mesh, by what hides them.
class LineLook {
public:
    LineLook(const DrawingView& view, const HidingBodies& bodies, float spacing, bool closed)
        : view_(view),
          bodies_(bodies),
          spacing_(spacing),
          closed_(closed)
    {
    }
    std::vector<Stroke> operator()(const ProbedLines& found, bool outline,
                                   const StrokeOptions& options) const
    {
        const ProbedLines lines = refined(found, spacing_, view_.to_image);
        std::vector<char> hidden(lines.lines.points.size(), 0);
        parallel_blocks(hidden.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                hidden[i] = is_hidden(lines.lines.points[i], lines.outlooks[i], outline);
        });
        return strokes(lines.lines, hidden, view_.to_image, options);
    }

private:
    bool is_hidden(const SilhouettePoint& point, const Outlook& outlook, bool outline) const
    {
        if (outline && closed_ && point.bend > 0) return true;
        const glm::dvec3 to_eye = -view_.from.sight(glm::dvec3(point.p));
        // An outline is seen from the side on which its surface bends away, else a line is from the
        // side that faces the eye.
        const bool turned =
            outline ? point.bend > 0 : glm::dot(glm::dvec3(outlook.normal), to_eye) < 0;
        const float length = glm::length(outlook.normal);
        const glm::vec3 aside = length > 0
                                    ? outlook.normal * ((turned ? -1 : 1) * outlook.height / length)
                                    : glm::vec3(0);
        const glm::dvec3 from(bodies_.to_scene * glm::dvec4(glm::dvec3(point.p + aside), 1)),
            way(bodies_.to_scene * glm::dvec4(to_eye, 0));
        const double whole = glm::length(way), scale = whole / glm::length(to_eye);
        const double end = view_.from.at.w == 0 ? 1e300 : whole;
        if (bodies_.scene.hit({from, way / whole}, scale * double{outlook.reach}, end)) return true;
        return bodies_.others &&
               bodies_.others(glm::dvec3(bodies_.to_scene * glm::dvec4(glm::dvec3(point.p), 1)));
    }

    const DrawingView& view_;
    const HidingBodies& bodies_;
    float spacing_;
    bool closed_;
};

class MeshDrawer {
public:
    MeshDrawer(const ShapedMesh& mesh, const LineDrawing& drawing, const DrawingView& view,
               const HidingBodies& bodies, const StrokeOptions& options)
        : mesh_(mesh),
          drawing_(drawing),
          view_(view),
          options_(options),
          look_(view, bodies, mesh.spacing, mesh.shape.closed)
    {
    }
    std::vector<KindStrokes> operator()()
    {
        const SurfaceShape& surface = mesh_.shape.surface;
        if (surface.corners.empty()) return {};
        std::vector<MeshShape::Edge> turning, creases, borders;
        for (const MeshShape::Edge& edge : mesh_.shape.edges)
            (edge.border ? borders : turns_away(edge) ? turning : creases).push_back(edge);
        if (drawing_.outlines) {
            add(LineKind::silhouettes,
                on_surface(surface, trivar::outlines(surface, view_.from), true));
            add(LineKind::silhouettes, on_edges(mesh_.shape, turning));
        }
        if (drawing_.borders) add(LineKind::borders, on_edges(mesh_.shape, borders));
        if (drawing_.creases) add(LineKind::creases, on_edges(mesh_.shape, creases));
        if (drawing_.more.suggestive)
            add(LineKind::suggestive,
                on_surface(surface, suggestive_lines(surface, view_.from, drawing_.more), false));
        for (const KindLines& each : mesh_.fixed)
            add(each.kind, on_surface(surface, each.lines, false));
        std::vector<Stroke*> all;
        for (KindStrokes& each : out_)
            for (Stroke& stroke : each.strokes) all.push_back(&stroke);
        hold_ends(all, meeting);
        return std::move(out_);
    }

private:
    bool turns_away(const MeshShape::Edge& edge) const
    {
        const glm::vec3 sight(view_.from.sight(glm::dvec3(mesh_.shape.points[edge.a])));
        return (glm::dot(edge.first, sight) > 0) != (glm::dot(edge.second, sight) > 0);
    }
    void add(LineKind kind, const ProbedLines& found)
    {
        StrokeOptions options = options_;
        if (kind != LineKind::silhouettes && kind != LineKind::borders && kind != LineKind::creases)
            options.shortest = std::max(options.shortest, shortest_on_mesh);
        std::vector<Stroke> made = look_(found, kind == LineKind::silhouettes, options);
        if (!made.empty()) out_.push_back({kind, std::move(made)});
    }

    const ShapedMesh& mesh_;
    const LineDrawing& drawing_;
    const DrawingView& view_;
    const StrokeOptions& options_;
    LineLook look_;
    std::vector<KindStrokes> out_;
};

} // namespace

ShapedMesh shaped_mesh(const Mesh& mesh, const LineDrawing& drawing, const glm::mat3& stretch,
                       float copy_size)
{
    ShapedMesh out{mesh_shape(mesh, drawing.crease_deg, stretch), {}};
    if (copy_size > 0) out.shape.surface.size = copy_size;
    out.spacing = (copy_size > 0 ? spacing_on_copy : point_spacing) * out.shape.surface.size;
    const float wide = drawing.more.smoothing;
    if (drawing.more.any())
        smooth_bends(out.shape.surface, static_cast<int>(std::lround(2 * wide * wide)));
    out.fixed = fixed_lines(out.shape.surface, drawing.more);
    return out;
}

std::vector<KindStrokes> mesh_strokes(const ShapedMesh& mesh, const LineDrawing& drawing,
                                      const DrawingView& view, const HidingBodies& bodies,
                                      const StrokeOptions& options)
{
    return MeshDrawer(mesh, drawing, view, bodies, options)();
}

std::vector<Stroke> intersection_strokes(const IntersectionLines& lines, float size,
                                         const DrawingView& view, const HidingBodies& bodies,
                                         const StrokeOptions& options)
{
    ProbedLines probed{lines.lines, {}};
    for (std::size_t i = 0; i < lines.normals.size(); ++i) {
        const glm::vec3 to_eye(-view.from.sight(glm::dvec3(lines.lines.points[i].p)));
        glm::vec3 normal(0);
        for (const glm::vec3& n : lines.normals[i]) normal += glm::dot(n, to_eye) < 0 ? -n : n;
        probed.outlooks.push_back({normal, off_surface * size, 0});
    }
    return LineLook(view, bodies, point_spacing * size, false)(probed, false, options);
}

LineStyle style_of(LineKind kind, const LineDrawing& drawing)
{
    return kind == LineKind::silhouettes || kind == LineKind::borders
               ? drawing.ink
               : finer(drawing.ink, drawing.more);
}

} // namespace trivar
