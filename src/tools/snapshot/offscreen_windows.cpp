// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "offscreen_windows.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace scan_to_path::tools {
namespace {

constexpr XID first_id = 0x40000;

std::map<XID, OffscreenWindow> windows;
XID next_id = first_id;

Visual makeVisual() {
  Visual visual = {};
  visual.visualid = visual_id;
  visual.c_class = TrueColor;
  visual.red_mask = 0xff0000;
  visual.green_mask = 0x00ff00;
  visual.blue_mask = 0x0000ff;
  visual.bits_per_rgb = 8;
  visual.map_entries = 256;
  return visual;
}

Screen makeScreen() {
  constexpr double mm_per_pixel = 25.4 / 96.0;
  Screen screen = {};
  screen.root = root_window;
  screen.width = screen_width;
  screen.height = screen_height;
  screen.mwidth = static_cast<int>(screen_width * mm_per_pixel);
  screen.mheight = static_cast<int>(screen_height * mm_per_pixel);
  screen.root_visual = offscreenVisual();
  screen.root_depth = 24;
  return screen;
}

/// Programs read a Display through Xlib's macros, that is, at the places that _XPrivDisplay has; the true struct is
/// larger, so there is room behind.
struct DisplayMemory {
  alignas(std::max_align_t) char bytes[8192] = {};

  DisplayMemory() {
    static char name[] = ":offscreen";
    auto* display = reinterpret_cast<_XPrivDisplay>(bytes);
    display->display_name = name;
    display->default_screen = 0;
    display->nscreens = 1;
    display->screens = offscreenScreen();
    display->screens->display = reinterpret_cast<Display*>(bytes);
  }
};

}  // namespace

Display* offscreenDisplay() {
  static DisplayMemory memory;
  return reinterpret_cast<Display*>(memory.bytes);
}

Screen* offscreenScreen() {
  static Screen screen = makeScreen();
  return &screen;
}

Visual* offscreenVisual() {
  static Visual visual = makeVisual();
  return &visual;
}

XID createWindow(unsigned width, unsigned height) {
  OffscreenWindow& window = windows[next_id];
  window.width = static_cast<int>(std::max(width, 1U));
  window.height = static_cast<int>(std::max(height, 1U));
  return next_id++;
}

OffscreenWindow* findWindow(XID id) {
  const auto found = windows.find(id);
  return found == windows.end() ? nullptr : &found->second;
}

void destroyWindow(XID id) {
  windows.erase(id);
  windowChanged(id);
}

}  // namespace scan_to_path::tools
