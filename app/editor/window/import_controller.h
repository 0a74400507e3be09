#pragma once

#include "app/editor/dialogs/import_dialog.h"
#include "app/editor/document/document.h"

#include <QObject>
#include <QWidget>

#include <functional>

namespace esm {

/// Makes organs of surfaces in mesh files.
class ImportController : public QObject {
    Q_OBJECT

public:
    /// @param mayLeaveProject asks the user where the organ that another would replace is not saved
    ImportController(QWidget& window, Document& document, std::function<bool()> mayLeaveProject);

    /// Asks for the file.
    void chooseMesh();
    /// Asks what it means; the organ then takes the place of the one before.
    void importMesh(const std::filesystem::path& file);

signals:
    void imported(const std::filesystem::path& file);

private:
    /// False where no such organ can be made, which is said, or the work was cancelled: the question stays.
    bool importAs(const ImportChoice& choice, const PolygonSoup& soup, const MeshSource& source,
                  const std::filesystem::path& file);

    QWidget& m_window;
    Document& m_document;
    std::function<bool()> m_mayLeaveProject;
};

} // namespace esm
