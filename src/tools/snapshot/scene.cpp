// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scene.h"

#include <OgreCamera.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreRenderTexture.h>
#include <OgreTextureManager.h>
#include <OgreViewport.h>
#include <rviz/config.h>
#include <rviz/display.h>
#include <rviz/display_group.h>
#include <rviz/ogre_helpers/render_system.h>
#include <rviz/properties/status_list.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <rviz/yaml_config_reader.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QThread>
#include <algorithm>
#include <functional>
#include <vector>

#include "scan_to_path/common/error.h"

namespace scan_to_path::tools {
namespace {

/// Displays take over what they received when a frame is drawn, and transform it by the next.
constexpr int settle_frames = 3;
constexpr int poll_ms = 2;

/// Pictures are drawn this many times larger along both sides and averaged: OSMesa has no anti-aliasing of its own.
constexpr int oversampling = 2;

void forEachDisplay(rviz::DisplayGroup* group, const std::function<void(rviz::Display*)>& visit) {
  for (int i = 0; i < group->numDisplays(); ++i) {
    rviz::Display* display = group->getDisplayAt(i);
    visit(display);
    if (auto* subgroup = dynamic_cast<rviz::DisplayGroup*>(display)) forEachDisplay(subgroup, visit);
  }
}

/// The status entries among a property's children.
std::vector<rviz::StatusProperty*> statusOf(rviz::Property* property) {
  std::vector<rviz::StatusProperty*> entries;
  for (int i = 0; i < property->numChildren(); ++i) {
    auto* list = dynamic_cast<rviz::StatusList*>(property->childAt(i));
    if (list == nullptr) continue;
    for (int k = 0; k < list->numChildren(); ++k) {
      if (auto* status = dynamic_cast<rviz::StatusProperty*>(list->childAt(k))) entries.push_back(status);
    }
  }
  return entries;
}

/// What a property's status first complains of, "" when all is Ok.
QString complaintOf(rviz::Property* property) {
  for (rviz::StatusProperty* status : statusOf(property)) {
    if (status->getLevel() != rviz::StatusProperty::Ok) return status->getName() + ": " + status->getValue().toString();
  }
  return "";
}

/// Displays are Ok as soon as they have a topic. Whether anything came, marker displays say by their namespaces, the
/// others by their topic's status, which then counts messages instead of being just "OK".
bool isWaiting(rviz::Display* display) {
  if (display->getClassId().startsWith("rviz/Marker")) return display->subProp("Namespaces")->numChildren() == 0;
  const auto entries = statusOf(display);
  return std::any_of(entries.begin(), entries.end(), [](rviz::StatusProperty* status) {
    return status->getName() == "Topic" && status->getValue().toString() == "OK";
  });
}

/// What displays still lack. What is wrong with the fixed frame, rviz looks at once a second: it is a reason to give,
/// and no reason to wait when all displays have what they show.
QStringList missing(rviz::DisplayGroup* root) {
  QStringList missing;
  forEachDisplay(root, [&](rviz::Display* display) {
    if (!display->isEnabled()) return;
    const QString complaint = isWaiting(display) ? QString("nothing received") : complaintOf(display);
    if (!complaint.isEmpty()) missing << "display '" + display->getName() + "': " + complaint;
  });
  const QString global = complaintOf(root);
  if (!missing.empty() && !global.isEmpty()) missing << global;
  return missing;
}

rviz::Config readConfig(const QString& file) {
  if (!QFileInfo(file).isReadable()) throw InputError(file.toStdString() + ": no such file, or not readable");
  rviz::Config config;
  rviz::YamlConfigReader reader;
  reader.readFile(config, file);
  if (reader.error()) throw InputError(file.toStdString() + ": " + reader.errorMessage().simplified().toStdString());
  const rviz::Config scene = config.mapGetChild("Visualization Manager");
  if (!scene.isValid()) throw InputError(file.toStdString() + ": no rviz configuration (no 'Visualization Manager')");
  return scene;
}

}  // namespace

Scene::Scene(const QString& config, QSize size) : size_(size) {
  const rviz::Config scene = readConfig(config);
  rviz::RenderSystem::disableAntiAliasing();
  panel_ = new rviz::RenderPanel();
  panel_->resize(size);
  panel_->show();
  QCoreApplication::processEvents();
  manager_ = new rviz::VisualizationManager(panel_);
  panel_->initialize(manager_->getSceneManager(), manager_);
  manager_->initialize();
  manager_->load(scene);
  manager_->startUpdate();
}

void Scene::disable(const QString& name) {
  bool found = false;
  forEachDisplay(manager_->getRootDisplayGroup(), [&](rviz::Display* display) {
    if (display->getName() != name || !display->isEnabled()) return;
    display->setEnabled(false);
    found = true;
  });
  if (!found) throw InputError("--disable " + name.toStdString() + ": no enabled display of that name");
}

void Scene::setView(const QString& name) {
  rviz::ViewManager* views = manager_->getViewManager();
  QStringList known;
  for (int i = 0; i < views->getNumViews(); ++i) {
    rviz::ViewController* view = views->getViewAt(i);
    known << view->getName();
    if (view->getName() != name) continue;
    views->setCurrentFrom(view);
    runFrames(settle_frames);
    return;
  }
  throw InputError("--view " + name.toStdString() +
                   ": no saved view of that name; saved: " + (known.empty() ? "none" : known.join(", ").toStdString()));
}

void Scene::runFrames(int count) {
  const uint64_t last = manager_->getFrameCount() + static_cast<uint64_t>(count);
  while (manager_->getFrameCount() < last) {
    QCoreApplication::processEvents();
    QThread::msleep(poll_ms);
  }
}

QStringList Scene::waitUntilShown(double timeout) {
  QElapsedTimer waited;
  waited.start();
  QStringList left = missing(manager_->getRootDisplayGroup());
  while (true) {
    while (!left.empty() && waited.elapsed() < 1e3 * timeout) {
      runFrames(1);
      left = missing(manager_->getRootDisplayGroup());
    }
    if (!left.empty()) return left;
    runFrames(settle_frames);
    left = missing(manager_->getRootDisplayGroup());
    if (left.empty()) return left;
  }
}

QImage Scene::draw() {
  const Ogre::Viewport* shown = panel_->getViewport();
  const QSize size = oversampling * size_;
  const auto width = static_cast<unsigned>(size.width());
  const auto height = static_cast<unsigned>(size.height());
  static int drawn = 0;
  const Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().createManual(
      "snapshot_" + std::to_string(drawn++), Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME, Ogre::TEX_TYPE_2D,
      width, height, 0, Ogre::PF_BYTE_RGB, Ogre::TU_RENDERTARGET);
  Ogre::RenderTexture* target = texture->getBuffer()->getRenderTarget();
  target->setAutoUpdated(false);
  Ogre::Viewport* viewport = target->addViewport(shown->getCamera());
  viewport->setBackgroundColour(shown->getBackgroundColour());
  viewport->setVisibilityMask(shown->getVisibilityMask());
  viewport->setMaterialScheme(shown->getMaterialScheme());
  viewport->setOverlaysEnabled(false);
  target->update();
  QImage image(size, QImage::Format_RGB32);
  target->copyContentsToMemory(Ogre::Box(0, 0, width, height),
                               Ogre::PixelBox(width, height, 1, Ogre::PF_X8R8G8B8, image.bits()),
                               Ogre::RenderTarget::FB_AUTO);
  return image.scaled(size_, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace scan_to_path::tools
