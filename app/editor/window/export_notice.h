#pragma once

#include "app/editor/document/document.h"
#include "widgets/view/view_notice.h"

namespace esm {

/// Says what was handed over and where it lies, until the organ is edited.
class ExportNotice : public QObject {
    Q_OBJECT

public:
    ExportNotice(QWidget& view, Document& document);

    /// @param file its full path
    void show(const QString& file);

private:
    ViewNotice* m_notice;
    QString m_file;
};

} // namespace esm
