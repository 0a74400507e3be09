#pragma once

#include "app/editor/document/document.h"
#include "core/render/camera.h"

#include <QObject>
#include <QWidget>

#include <functional>

namespace esm {

struct Actions;

/// Lays photos on the organ, and layers to paint.
class PhotoController : public QObject {
    Q_OBJECT

public:
    /// @param camera where the user looks from: a new photo is projected from there
    PhotoController(QWidget& window, Document& document, std::function<Camera()> camera);

    void connectActions(const Actions& actions);

    void addPhoto(const std::filesystem::path& file);
    void addPaint();

signals:
    void message(const QString& text);
    void photoAdded();
    void paintAdded();

private:
    void choosePhoto();
    std::shared_ptr<const Atlas> atlasForPhotos();

    QWidget& m_window;
    Document& m_document;
    std::function<Camera()> m_camera;
};

} // namespace esm
