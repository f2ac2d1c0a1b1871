// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <X11/Xlib.h>

#include <vector>

/// What stands behind the display, the windows and the pixel buffers that Xlib and GLX hand out here: memory.
namespace scan_to_path::tools {

constexpr Window root_window = 1;
constexpr VisualID visual_id = 0x21;
constexpr int screen_width = 1920;   // [pixel]
constexpr int screen_height = 1080;  // [pixel]

/// A window or a pixel buffer of GLX: both are something of a size that can be drawn to.
struct OffscreenWindow {
  int width = 1;
  int height = 1;
  std::vector<unsigned char> pixels;  ///< RGBA, bottom row first; of the size above once drawn to
};

/// The one display, with one true-colour visual of 24 bits on one screen.
Display* offscreenDisplay();
Screen* offscreenScreen();
Visual* offscreenVisual();

/// A new one; never the id of an older one.
XID createWindow(unsigned width, unsigned height);

/// Null for the root and for what has been destroyed.
OffscreenWindow* findWindow(XID id);

void destroyWindow(XID id);

/// Called when a window got another size or is gone: the current GLX context must not draw to its old pixels.
void windowChanged(XID id);

}  // namespace scan_to_path::tools
