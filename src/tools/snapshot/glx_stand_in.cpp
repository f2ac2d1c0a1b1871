// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0

// GLX 1.4 as far as OGRE's GLX support and rviz use it, on top of OSMesa, which draws into memory. Contexts are
// OSMesa's own behind another name; windows and pixel buffers are those of offscreen_windows.h. Signatures: the GLX 1.4
// specification. libOSMesa has to come before librviz on the link line, so that the gl… calls of all libraries are its.

#include <GL/gl.h>
#include <GL/glx.h>
#include <GL/osmesa.h>
#include <X11/Xutil.h>
#include <dlfcn.h>

#include <cstdlib>
#include <string>

#include "offscreen_windows.h"

namespace tools = scan_to_path::tools;

namespace {

OSMesaContext current_context = nullptr;
GLXDrawable current_drawable = None;

/// There is one framebuffer configuration; GLX hands it out by an opaque pointer that nobody looks behind.
char the_configuration = 0;

OSMesaContext toMesa(GLXContext context) { return reinterpret_cast<OSMesaContext>(context); }
GLXContext toGlx(OSMesaContext context) { return reinterpret_cast<GLXContext>(context); }

/// Memory that the caller gives back with XFree.
template <class T>
T* allocate() {
  return static_cast<T*>(std::calloc(1, sizeof(T)));
}

int configurationAttribute(int attribute) {
  switch (attribute) {
    case GLX_RED_SIZE:
    case GLX_GREEN_SIZE:
    case GLX_BLUE_SIZE:
    case GLX_ALPHA_SIZE:
    case GLX_STENCIL_SIZE:
      return 8;
    case GLX_DEPTH_SIZE:
      return 24;
    case GLX_BUFFER_SIZE:
      return 32;
    case GLX_RGBA:
    case GLX_USE_GL:
    case GLX_DOUBLEBUFFER:
    case GLX_X_RENDERABLE:
    case GLX_FBCONFIG_ID:
      return 1;
    case GLX_CONFIG_CAVEAT:
      return GLX_NONE;
    case GLX_RENDER_TYPE:
      return GLX_RGBA_BIT;
    case GLX_DRAWABLE_TYPE:
      return GLX_WINDOW_BIT | GLX_PBUFFER_BIT;
    case GLX_VISUAL_ID:
      return static_cast<int>(tools::visual_id);
    case GLX_X_VISUAL_TYPE:
      return GLX_TRUE_COLOR;
    default:
      return 0;  // no samples, no auxiliary, accumulation or stereo buffers
  }
}

XVisualInfo* visualInfo() {
  const Visual* visual = tools::offscreenVisual();
  auto* info = allocate<XVisualInfo>();
  info->visual = tools::offscreenVisual();
  info->visualid = visual->visualid;
  info->depth = 24;
  info->c_class = visual->c_class;
  info->red_mask = visual->red_mask;
  info->green_mask = visual->green_mask;
  info->blue_mask = visual->blue_mask;
  info->colormap_size = visual->map_entries;
  info->bits_per_rgb = visual->bits_per_rgb;
  return info;
}

/// OGRE's GL render system uses the fixed pipeline beside shaders: hence the compatibility profile.
GLXContext createContext(GLXContext share) {
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_STENCIL_BITS,
                            8,
                            OSMESA_ACCUM_BITS,
                            0,
                            OSMESA_PROFILE,
                            OSMESA_COMPAT_PROFILE,
                            0};
  return toGlx(OSMesaCreateContextAttribs(attributes, toMesa(share)));
}

/// Has the current context draw into the current drawable's pixels, or into a few nobody reads.
bool bindCurrent() {
  static tools::OffscreenWindow nowhere{64, 64, {}};
  tools::OffscreenWindow* found = tools::findWindow(current_drawable);
  tools::OffscreenWindow& window = found ? *found : nowhere;
  window.pixels.resize(4 * static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height));
  return OSMesaMakeCurrent(current_context, window.pixels.data(), GL_UNSIGNED_BYTE, window.width, window.height) ==
         GL_TRUE;
}

void releaseCurrent() {
  if (current_context != nullptr) {
    glFinish();
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  }
  current_context = nullptr;
  current_drawable = None;
}

}  // namespace

void tools::windowChanged(XID id) {
  if (id == current_drawable && current_context != nullptr) bindCurrent();
}

extern "C" {

// What there is

Bool glXQueryVersion(Display*, int* major, int* minor) {
  *major = 1;
  *minor = 4;
  return True;
}

const char* glXGetClientString(Display*, int name) {
  switch (name) {
    case GLX_VERSION:
      return "1.4";
    case GLX_VENDOR:
      return "OSMesa";
    default:
      return "GLX_ARB_create_context GLX_ARB_create_context_profile";
  }
}

const char* glXQueryExtensionsString(Display* display, int /*screen*/) {
  return glXGetClientString(display, GLX_EXTENSIONS);
}

// Configurations and visuals: one

GLXFBConfig* glXChooseFBConfig(Display*, int /*screen*/, const int* /*attributes*/, int* count) {
  auto* configurations = allocate<GLXFBConfig>();
  configurations[0] = reinterpret_cast<GLXFBConfig>(&the_configuration);
  *count = 1;
  return configurations;
}

GLXFBConfig* glXGetFBConfigs(Display* display, int screen, int* count) {
  return glXChooseFBConfig(display, screen, nullptr, count);
}

int glXGetFBConfigAttrib(Display*, GLXFBConfig, int attribute, int* value) {
  *value = configurationAttribute(attribute);
  return Success;
}

int glXGetConfig(Display*, XVisualInfo*, int attribute, int* value) {
  *value = configurationAttribute(attribute);
  return Success;
}

XVisualInfo* glXChooseVisual(Display*, int /*screen*/, int* /*attributes*/) { return visualInfo(); }
XVisualInfo* glXGetVisualFromFBConfig(Display*, GLXFBConfig) { return visualInfo(); }

// Contexts

GLXContext glXCreateContext(Display*, XVisualInfo*, GLXContext share, Bool /*direct*/) { return createContext(share); }

GLXContext glXCreateNewContext(Display*, GLXFBConfig, int /*type*/, GLXContext share, Bool /*direct*/) {
  return createContext(share);
}

GLXContext glXCreateContextAttribsARB(Display*, GLXFBConfig, GLXContext share, Bool /*direct*/,
                                      const int* /*attributes*/) {
  return createContext(share);
}

void glXDestroyContext(Display*, GLXContext context) {
  if (toMesa(context) == current_context) releaseCurrent();
  OSMesaDestroyContext(toMesa(context));
}

Bool glXMakeCurrent(Display*, GLXDrawable drawable, GLXContext context) {
  if (context == nullptr) {
    releaseCurrent();
    return True;
  }
  if (toMesa(context) == current_context && drawable == current_drawable) return True;
  current_context = toMesa(context);
  current_drawable = drawable;
  return bindCurrent() ? True : False;
}

Bool glXMakeContextCurrent(Display* display, GLXDrawable draw, GLXDrawable /*read*/, GLXContext context) {
  return glXMakeCurrent(display, draw, context);
}

GLXContext glXGetCurrentContext() { return toGlx(current_context); }
GLXDrawable glXGetCurrentDrawable() { return current_drawable; }
Display* glXGetCurrentDisplay() { return current_context ? tools::offscreenDisplay() : nullptr; }

int glXQueryContext(Display*, GLXContext, int attribute, int* value) {
  *value = configurationAttribute(attribute);
  return Success;
}

// Drawables

GLXPbuffer glXCreatePbuffer(Display*, GLXFBConfig, const int* attributes) {
  unsigned width = 1;
  unsigned height = 1;
  for (; attributes != nullptr && attributes[0] != None; attributes += 2) {
    if (attributes[0] == GLX_PBUFFER_WIDTH) width = static_cast<unsigned>(attributes[1]);
    if (attributes[0] == GLX_PBUFFER_HEIGHT) height = static_cast<unsigned>(attributes[1]);
  }
  return tools::createWindow(width, height);
}

void glXDestroyPbuffer(Display*, GLXPbuffer id) { tools::destroyWindow(id); }

void glXQueryDrawable(Display*, GLXDrawable id, int attribute, unsigned* value) {
  const tools::OffscreenWindow* window = tools::findWindow(id);
  switch (attribute) {
    case GLX_WIDTH:
      *value = static_cast<unsigned>(window ? window->width : 1);
      break;
    case GLX_HEIGHT:
      *value = static_cast<unsigned>(window ? window->height : 1);
      break;
    default:
      *value = static_cast<unsigned>(configurationAttribute(attribute));
  }
}

void glXSwapBuffers(Display*, GLXDrawable) { glFinish(); }

// Functions by name: GLX's from this file, OpenGL's from OSMesa

__GLXextFuncPtr glXGetProcAddressARB(const GLubyte* name) {
  const std::string text = reinterpret_cast<const char*>(name);
  if (text == "glXCreateContextAttribsARB") return reinterpret_cast<__GLXextFuncPtr>(glXCreateContextAttribsARB);
  if (text.rfind("glX", 0) == 0) return reinterpret_cast<__GLXextFuncPtr>(dlsym(RTLD_DEFAULT, text.c_str()));
  return reinterpret_cast<__GLXextFuncPtr>(OSMesaGetProcAddress(text.c_str()));
}

__GLXextFuncPtr glXGetProcAddress(const GLubyte* name) { return glXGetProcAddressARB(name); }

}  // extern "C"
