// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/limit/surface_point.h"

#include <vector>

namespace trivar {

// The kind of brush, which decides the effect of a stroke.
enum class TileBrush {
    scatter, // lays tiles all over the width of the brush
    line,    // lays tiles one behind the other
    fill,    // lays tiles all over the area that the stroke touches
    erase,   // removes tiles
    comb,    // turns tiles toward the direction of the stroke
    resize,  // makes tiles larger, or smaller where the strength is negative
    raise,   // makes tiles higher, or lower where the strength is negative
    grab,    // takes tiles to another place: the first one to the last sample
    strand,  // lays tiles end to end: each shares its ends with those before and behind it
    color,   // brings the colours of tiles nearer to its own
    morph,   // lets tiles become the layer's other shape, or what they were
    adjust,  // turns, scales or removes single tiles
};

// The direction in which the x axis of a new tile points. Where the surface bends alike in all
// directions, curvature says nothing, and tiles head along the stroke.
enum class TileHeading { along_stroke, upward, random, least_curvature, most_curvature, to_point };

// The area that a fill covers: the surfaces connected with those that the stroke touches, all that
// has a material that it touches, the faces that it touches, or all of the base.
enum class TileArea { island, material, faces, all };

// The plane through the origin of the base's model over which a stroke works a second time.
enum class TileMirror { none, x, y, z };

struct TileSample {
    SurfacePoint at;     // on the base at rest
    double time_s = 0;   // since the stroke began
    double pressure = 1; // 0..1, a factor of the size of new tiles or of the strength
    bool operator==(const TileSample&) const = default;
};

// A TileStroke is one stroke of a brush. Lengths are metres on the base's model at rest.
struct TileStroke {
    TileBrush brush = TileBrush::scatter;
    std::vector<TileSample> samples;
    double radius = 0.1; // of the brush
    double size = 0.05;  // side of a new tile
    double spacing = 1;  // least distance between the middles of new tiles and others, in sizes
    double height = 1;   // factor of the height of new tiles
    double size_variation = 0;     // 0..1: sizes are smaller by up to that share
    double turn_variation_deg = 0; // new tiles are turned by up to that angle either way
    TileHeading heading = TileHeading::along_stroke;
    double strength = 0.5; // of comb, resize, raise, color and morph; -1..1
    int seed = 1;
    bool hidden = false; // it does nothing
    double width = 1;    // of a strand: factor of the width of its tiles
    double taper = 0;   // of a strand: 0..1, the share by which it is narrower and lower at its end
    bool apart = false; // of a strand: its ends do not join with others near them
    glm::dvec3 point{0}; // that tiles head to, on the model
    TileArea area = {};  // of a fill
    TileMirror mirror = {};
    bool mirrors_tiles = false; // tiles beyond the mirror are mirror images, too; none of a strand
    glm::dvec3 color{1};        // of the brush color, linear, 0..1: a factor of the material's
    double turn_deg = 0;        // by which adjusted tiles are turned about their normals
    double factor = 1;          // of the sizes of adjusted tiles; 0: they are removed
    bool operator==(const TileStroke&) const = default;
};

// A TileLook holds the settings common to all tiles of a layer.
struct TileLook {
    double scale = 1;             // factor of the sizes of all tiles
    double height = 1;            // factor of the heights of all tiles
    double sink = 0;              // how deep tiles stand in the base, as a share of their height
    double turn_deg = 0;          // of all tiles about their normals
    bool guard = true;            // tiles that would fold are lowered until they do not
    double growth = 1;            // 0..1: the share of the time of painting whose tiles are there
    double growth_softness = 0.1; // share of that time in which a tile grows
    double wave = 0;              // by how much heights go up and down, as a share of them
    double wave_phase = 0;        // turns; keys on it let the wave run
    double wave_length = 0;       // metres on the model; 0: all tiles move at once
    glm::dvec3 wave_direction{0}; // in the model's space, of any length; 0: along Z
    double wave_variation = 0;    // turns by which tiles differ at random
    double morph = 0;             // how far tiles have become another shape: 0 not, 1 altogether
    double morph_variation = 0;   // share of the morph by which the last tiles are behind the first
    double clip_variation = 0;    // share of a clip by which tiles differ at random
    int phases = 8;               // number of tiles that differ so; the others are like one of them
    double slide_x = 0, slide_y = 0; // how far tiles have gone along their own axes, in sides
    double slide_along = 0;          // how far tiles of lines have gone along their strokes
    bool keep_overlaps = true;       // tiles that overlap earlier ones stay; else they are left out
    // The unit cell: the part of the tile's box, in shares of its sides, that fills the place of a
    // tile; the rest reaches over the tiles beside it.
    double cell_x0 = 0, cell_x1 = 1, cell_y0 = 0, cell_y1 = 1;
    double base_level = 0;    // what lies on the surface, as a share of the box's height
    double overlap = 0;       // of strands: how far tiles reach into the next ones, in cells
    double roll_deg = 0;      // of strands: turn of all tiles about the strand
    double alternate_deg = 0; // of strands: turn of every other tile about the strand, besides
    bool operator==(const TileLook&) const = default;
};

// The most tiles of a layer.
inline constexpr std::size_t most_tiles = 200'000;

} // namespace trivar
