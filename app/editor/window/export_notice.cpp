#include "app/editor/window/export_notice.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QUrl>

namespace esm {

ExportNotice::ExportNotice(QWidget& view, Document& document)
    : QObject(&view), m_notice(new ViewNotice(view)) {
    m_notice->setProperty("hint", true); // no warning
    connect(m_notice, &ViewNotice::helpAsked, this, [this] {
        QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(m_file).absolutePath()));
        m_notice->hide();
    });
    connect(&document, &Document::changed, m_notice, &QWidget::hide);
}

void ExportNotice::show(const QString& file) {
    m_file = file;
    const QFileInfo info(file);
    m_notice->say(tr("Exported %1, %2, to %3")
                      .arg(info.fileName(), QLocale().formattedDataSize(info.size()),
                           QDir::toNativeSeparators(info.absolutePath())),
                  tr("Open folder"), tr("Show the folder that the file lies in"));
}

} // namespace esm
