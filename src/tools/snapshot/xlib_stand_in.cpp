// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0

// The calls of Xlib that OGRE's GLX support, rviz::RenderSystem and Qt's offscreen platform make when they open a
// display, make windows and size them, without an X server behind them. They stand in the executable, so the dynamic
// linker takes them before libX11's; what is not here (hints and text properties, plain memory) stays libX11's.
// Signatures and what results mean: the Xlib manual ("Xlib - C Language X Interface").

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <cstdio>
#include <cstdlib>

#include "offscreen_windows.h"

namespace tools = scan_to_path::tools;

namespace {

constexpr Status success = 1;  // of calls that return a Status, other than those that return Success
XErrorHandler error_handler = nullptr;

}  // namespace

extern "C" {

// The display

Display* XOpenDisplay(const char* /*name*/) { return tools::offscreenDisplay(); }
int XCloseDisplay(Display*) { return 0; }
char* XDisplayName(const char* /*name*/) { return DisplayString(tools::offscreenDisplay()); }
Status XInitThreads() { return success; }
int XSync(Display*, Bool /*discard*/) { return 0; }
int XFlush(Display*) { return 0; }
int XFree(void* memory) {
  std::free(memory);
  return 1;
}

/// No extensions: OGRE then leaves RandR's list of full-screen modes alone.
Bool XQueryExtension(Display*, const char* /*name*/, int* opcode, int* event, int* error) {
  *opcode = *event = *error = 0;
  return False;
}

Atom XInternAtom(Display*, const char* /*name*/, Bool /*only_if_exists*/) { return None; }

XErrorHandler XSetErrorHandler(XErrorHandler handler) {
  XErrorHandler before = error_handler;
  error_handler = handler;
  return before;
}

int XGetErrorText(Display*, int code, char* text, int size) {
  std::snprintf(text, static_cast<std::size_t>(size), "X error %d", code);
  return 0;
}

// Colours: true colour, so a map is a name only

Colormap XCreateColormap(Display*, Window, Visual*, int /*alloc*/) { return 1; }
int XFreeColormap(Display*, Colormap) { return 0; }
VisualID XVisualIDFromVisual(Visual* visual) { return visual->visualid; }

// Windows

Window XCreateWindow(Display*, Window /*parent*/, int /*x*/, int /*y*/, unsigned width, unsigned height,
                     unsigned /*border*/, int /*depth*/, unsigned /*class*/, Visual*, unsigned long /*mask*/,
                     XSetWindowAttributes*) {
  return tools::createWindow(width, height);
}

Window XCreateSimpleWindow(Display*, Window /*parent*/, int /*x*/, int /*y*/, unsigned width, unsigned height,
                           unsigned /*border*/, unsigned long /*border_colour*/, unsigned long /*background*/) {
  return tools::createWindow(width, height);
}

int XDestroyWindow(Display*, Window id) {
  tools::destroyWindow(id);
  return 0;
}

int XMapWindow(Display*, Window) { return 0; }
int XUnmapWindow(Display*, Window) { return 0; }
int XMoveWindow(Display*, Window, int /*x*/, int /*y*/) { return 0; }

int XResizeWindow(Display*, Window id, unsigned width, unsigned height) {
  if (tools::OffscreenWindow* window = tools::findWindow(id)) {
    window->width = static_cast<int>(width);
    window->height = static_cast<int>(height);
    tools::windowChanged(id);
  }
  return 0;
}

Status XGetWindowAttributes(Display*, Window id, XWindowAttributes* attributes) {
  const tools::OffscreenWindow* window = tools::findWindow(id);
  *attributes = {};
  attributes->width = window ? window->width : tools::screen_width;
  attributes->height = window ? window->height : tools::screen_height;
  attributes->depth = 24;
  attributes->visual = tools::offscreenVisual();
  attributes->root = tools::root_window;
  attributes->screen = tools::offscreenScreen();
  attributes->map_state = IsViewable;
  return success;
}

Status XQueryTree(Display*, Window, Window* root, Window* parent, Window** children, unsigned* count) {
  *root = *parent = tools::root_window;
  *children = nullptr;
  *count = 0;
  return success;
}

// There is no window manager to tell anything

void XSetWMProperties(Display*, Window, XTextProperty* /*name*/, XTextProperty* /*icon*/, char** /*argv*/, int /*argc*/,
                      XSizeHints*, XWMHints*, XClassHint*) {}
Status XSetWMProtocols(Display*, Window, Atom* /*protocols*/, int /*count*/) { return success; }
Status XSendEvent(Display*, Window, Bool /*propagate*/, long /*mask*/, XEvent*) { return success; }

}  // extern "C"
