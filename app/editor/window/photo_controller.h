#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "core/render/camera.h"

#include <QObject>
#include <QWidget>

#include <functional>
#include <vector>

namespace esm {

struct Actions;

/// Lays photos on the organ, and layers to paint; hides, duplicates and replaces the
/// selected one.
class PhotoController : public QObject {
    Q_OBJECT

public:
    /// @param camera where the user looks from: a new photo is projected from there
    PhotoController(QWidget& window, Document& document, Selection& selection,
                    std::function<Camera()> camera);

    void connectActions(const Actions& actions);

    /// All that can be read, as one step; of the others is said why they cannot.
    void addPhotos(const std::vector<std::filesystem::path>& files);
    void addPaint();
    /// Another file in the place of the selected photo; asks where that has another shape.
    void replacePhoto(const std::filesystem::path& file);

signals:
    void message(const QString& text);
    void photoAdded();
    void paintAdded();

private:
    struct ReadPhotos {
        std::vector<std::shared_ptr<const Photo>> photos;
        std::vector<std::string> refused; ///< a line for each file that is no photo
    };

    void choosePhotos();
    void chooseReplacement();
    bool mayChangeShape(const Photo& before, const Photo& after);
    ReadPhotos readPhotos(const std::vector<std::filesystem::path>& files);
    void lay(const std::vector<std::shared_ptr<const Photo>>& photos);
    void enable(const Actions& actions);
    std::shared_ptr<const Atlas> atlasForPhotos();

    QWidget& m_window;
    Document& m_document;
    Selection& m_selection;
    std::function<Camera()> m_camera;
};

} // namespace esm
