// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Glyphs of Font Awesome 4.7 as UTF-8, by what they mean here.

namespace trivar::ui::icon {

inline constexpr const char *select = "\uf245", *move = "\uf047", *rotate = "\uf01e",
                            *scale = "\uf065", *place = "\uf040", *press = "\uf192",
                            *tiles = "\uf00a", *scene = "\uf0e8", *mesh = "\uf1b2",
                            *volume = "\uf1b3", *camera = "\uf03d", *sliders = "\uf1de",
                            *eye = "\uf06e", *hidden = "\uf070", *add = "\uf067", *minus = "\uf068",
                            *trash = "\uf1f8", *close = "\uf00d", *check = "\uf00c",
                            *search = "\uf002", *open = "\uf107", *closed = "\uf105",
                            *undo = "\uf112", *redo = "\uf064", *history = "\uf1da",
                            *settings = "\uf013", *timing = "\uf0e4", *guard = "\uf132",
                            *warning = "\uf071", *information = "\uf05a", *help = "\uf128",
                            *keyboard = "\uf11c", *file = "\uf016", *folder = "\uf114",
                            *open_file = "\uf07c", *import = "\uf019", *save = "\uf0c7",
                            *image = "\uf03e", *reset = "\uf021", *target = "\uf05b",
                            *level_up = "\uf148", *home = "\uf015", *link = "\uf0c1",
                            *group = "\uf247", *grid = "\uf0ce", *log = "\uf120", *copy = "\uf0c5",
                            *pencil = "\uf044", *drop = "\uf043", *command = "\uf138",
                            *lock = "\uf023", *open_lock = "\uf09c", *more = "\uf141",
                            *travel = "\uf018", *first = "\uf048", *back = "\uf04a",
                            *play = "\uf04b", *pause = "\uf04c", *forward = "\uf04e",
                            *last = "\uf051", *again = "\uf079", *mask = "\uf1fc",
                            *silhouettes = "\uf042", *split = "\uf127", *incise = "\uf0c4",
                            *tetrahedra = "\uf20e", *reverse = "\uf07e", *mirror = "\uf0ec";

} // namespace trivar::ui::icon
