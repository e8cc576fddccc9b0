// Looks that were put aside while working: the whole document and the picture it had. They live as long as the window.
#pragma once

#include <QImage>
#include <QObject>
#include <memory>
#include <vector>

#include "ui/document/sections.h"

namespace dermis {

class Document;

struct Snapshot {
  QString name;
  WholeLook look;
  std::shared_ptr<const ResolvedScene> scene;  ///< the same, as the renderer takes it
  QImage thumbnail;                            ///< null: there is none yet
};

class Snapshots : public QObject {
  Q_OBJECT
 public:
  static constexpr QSize kPicture{192, 128};

  explicit Snapshots(Document& document, QObject* parent = nullptr) : QObject(parent), m_document(document) {}
  [[nodiscard]] const std::vector<Snapshot>& all() const { return m_all; }
  /// Keeps the document as it is; `picture` is what it looks like, null where nothing has drawn it yet.
  void take(const QImage& picture);
  /// The first without a picture, -1: all have one.
  [[nodiscard]] int undrawn() const;
  /// The picture of the snapshot with this scene, if it is still there.
  void setPicture(const ResolvedScene* scene, const QImage& picture);
  void rename(std::size_t index, const QString& name);
  void remove(std::size_t index);
  /// Puts it back, as one undo entry; the camera stays where it is.
  void restore(std::size_t index);

 Q_SIGNALS:
  void changed();

 private:
  Document& m_document;
  std::vector<Snapshot> m_all;
  int m_taken = 0;
};

}  // namespace dermis
