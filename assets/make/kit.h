// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The headers that every model is made with.
#include "assets/make/field.h"
#include "assets/make/loft.h"
#include "assets/make/mesh.h"
#include "assets/make/outline.h"
#include "assets/make/parts.h"
#include "assets/make/skin.h"
#include "assets/make/surface.h"
