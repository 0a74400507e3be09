#include "app/editor/window/export_notice.h"

#include "core/exchange/simulators/exporters.h"

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

namespace {

qint64 bytesOf(const QString& exported) {
    qint64 bytes = 0;
    for (const std::filesystem::path& file : exportedFiles(exported.toStdString()))
        bytes += QFileInfo(QString::fromStdString(file.string())).size();
    return bytes;
}

} // namespace

void ExportNotice::show(const QString& file) {
    m_file = file;
    const QFileInfo info(file);
    m_notice->say(tr("Exported %1, %2, to %3")
                      .arg(info.fileName(), QLocale().formattedDataSize(bytesOf(file)),
                           QDir::toNativeSeparators(info.absolutePath())),
                  tr("Open folder"), tr("Show the folder that the file lies in"));
}

} // namespace esm
